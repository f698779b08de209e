//! A picture of a plan over the depth of the bit.

use super::Plan;
use crate::{
    figure::{Axis, Figure, Interval, Key, Layout, Panel, Range},
    plots::Shown,
};

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
            panel_mm: 100.0,
        },
        shared: depth,
        panels,
        hole: hole.map(interval).collect(),
    }
}

fn deepest_m(plan: &Plan) -> f64 {
    let depths = plan.curves.iter().flat_map(|of| &of.points).map(|of| of.bit_depth_m);
    let theirs = plan.overlay.iter().flat_map(|of| &of.rows).map(|of| of.bit_depth_m);
    let read = plan.measured.iter().map(|of| of.bit_depth_m);
    depths.chain(read).chain(theirs).fold(0.0, f64::max)
}
