//! A picture of a plan over the depth of the bit.

use wholestring::well::FrictionLevel;
use wholestring_results::{PlanFriction, PlanSummary};

use super::Plan;
use crate::{
    figure::{Axis, Figure, Ink, Interval, Key, Layout, Mark, Panel, Range, Shape, Stroke},
    plots::DisplayUnits,
};

/// A line through points, and a mark at each that has no neighbour, because a line of one point is
/// invisible.
pub(super) fn line(ink: Ink, stroke: Stroke, shape: Shape, points: Vec<(f64, f64)>) -> Vec<Mark> {
    let is_there = |place: usize| points.get(place).is_some_and(|point| point.1.is_finite());
    let is_lone = |place: &usize| {
        let has_above = place.checked_sub(1).is_some_and(is_there);
        is_there(*place) && !has_above && !is_there(place + 1)
    };
    let lone: Vec<(f64, f64)> =
        (0..points.len()).filter(is_lone).map(|place| points[place]).collect();
    let mut marks = vec![Mark::Curve { ink, stroke, points }];
    if !lone.is_empty() {
        marks.push(Mark::Points { ink, shape, points: lone });
    }
    marks
}

/// Panels in a line over depth, with the hole next to them.
pub(super) fn over_depth(
    plan: &Plan,
    display: DisplayUnits<'_>,
    subtitle: &str,
    keys: Vec<Key>,
    panels: Vec<Panel>,
) -> Figure {
    let deepest_m = deepest_m(plan);
    let depth = Axis {
        down: true,
        ..Axis::new(
            display.label("Measured depth of the bit", "length"),
            // Room below the ends of the lines for their names.
            Range::Fixed(0.0, 1.07 * display.value(deepest_m, "length")),
        )
    };
    let hole = hole(plan).filter(|(section, _)| section.from_md_m < deepest_m);
    let interval = |(section, diameter_m): (&PlanFriction, f64)| {
        let cased = section.kind == "casing";
        let name = if cased { "casing" } else { "open hole" };
        Interval {
            from: display.value(section.from_md_m, "length"),
            to: display.value(section.to_md_m.min(deepest_m), "length"),
            cased,
            shoe: cased && section.to_md_m <= deepest_m,
            label: format!("{name}, {}", display.quantity(diameter_m, "diameter")),
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

/// Sections of the hole and their diameters, m; not a number where the settings have none.
fn hole(plan: &Plan) -> impl Iterator<Item = (&PlanFriction, f64)> {
    let sections = plan.summary.frictions.iter();
    // Each level of friction has the same sections.
    let sections = sections.filter(|section| section.friction == FrictionLevel::Expected);
    let diameters = plan.summary.hole_diameters_m();
    sections.zip(diameters.map(|diameter_m| diameter_m.unwrap_or(f64::NAN)))
}

fn deepest_m(plan: &Plan) -> f64 {
    let PlanSummary { points, overlay, measured, .. } = &plan.summary;
    let depths = points.iter().map(|point| point.bit_depth_m);
    let theirs = overlay.iter().flat_map(|overlay| &overlay.rows).map(|row| row.bit_depth_m);
    let read = measured.iter().map(|measured| measured.bit_depth_m);
    depths.chain(read).chain(theirs).fold(0.0, f64::max)
}
