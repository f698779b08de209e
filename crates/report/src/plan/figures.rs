//! All pictures of a plan.

use super::{Plan, broomstick, buckling};
use crate::{
    Plot,
    figure::{Axis, Figure, Interval, Key, Layout, Panel, Range},
    plots::Shown,
};

/// Every picture of a plan, in a set of units (`si`, `metric` or `field`): `hook_load`, `torque` and
/// `buckling_weight`; of each only where there is something to draw.
pub fn plan_plots(plan: &Plan, units: &str) -> Vec<Plot> {
    let shown = Shown::new(&plan.head.dimensions, units);
    let pictures = [
        ("hook_load", broomstick::hook_load(plan, shown)),
        ("torque", broomstick::torque(plan, shown)),
        ("buckling_weight", buckling::figure(plan, shown)),
    ];
    let plot =
        |(name, figure): (&str, Option<Figure>)| Some(Plot { name: name.into(), figure: figure? });
    pictures.into_iter().filter_map(plot).collect()
}

/// Panels side by side over depth, with the hole beside them.
pub(super) fn over_depth(
    plan: &Plan,
    shown: Shown<'_>,
    subtitle: &str,
    keys: Vec<Key>,
    panels: Vec<Panel>,
) -> Figure {
    let deepest_m = deepest_m(plan);
    let depth = Axis {
        down: true,
        ..Axis::new(
            shown.label("Measured depth of the bit", "length"),
            // Room below the ends of the lines for their names.
            Range::Fixed(0.0, 1.07 * shown.value(deepest_m, "length")),
        )
    };
    let hole = plan.hole.iter().filter(|section| section.from_m < deepest_m);
    let interval = |section: &crate::Section| {
        let cased = section.kind == "casing";
        let name = if cased { "casing" } else { "open hole" };
        Interval {
            from: shown.value(section.from_m, "length"),
            to: shown.value(section.to_m.min(deepest_m), "length"),
            cased,
            shoe: cased && section.to_m <= deepest_m,
            label: format!("{name}, {}", shown.quantity(section.diameter_m, "diameter")),
        }
    };
    Figure {
        title: plan.head.title.clone(),
        subtitle: subtitle.to_owned(),
        keys,
        layout: Layout {
            direction: crate::figure::Direction::Down,
            columns: panels.len().max(1),
            width_mm: 180.0,
            panel_mm: 120.0,
        },
        shared: depth,
        panels,
        hole: hole.map(interval).collect(),
    }
}

fn deepest_m(plan: &Plan) -> f64 {
    let depths = plan.curves.iter().flat_map(|of| &of.points).map(|of| of.bit_depth_m);
    depths.fold(0.0, f64::max)
}
