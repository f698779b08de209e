//! Results of a plan grouped into curves against the depth of the bit, and a picture over that
//! depth.

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_results::{PlanBuckling, PlanFriction, PlanPoint, PlanSummary};

use super::{Plan, levels::Level};
use crate::{
    figure::{Axis, Figure, Ink, Interval, Key, Layout, Mark, Panel, Range, Shape, Stroke},
    plots::DisplayUnits,
};

/// One operation by one model with one friction, down the hole.
pub(super) struct Curve<'a> {
    /// The model.
    pub(super) model: ModelKind,
    /// The operation.
    pub(super) operation: OperationKind,
    /// Its level of friction.
    pub(super) level: &'a Level,
    /// Depth after depth.
    pub(super) points: Vec<&'a PlanPoint>,
}

/// Weights on bit at which the string begins to buckle, down the hole.
pub(super) struct BucklingCurve<'a> {
    /// The operation: `drill` or `slide`.
    pub(super) operation: OperationKind,
    /// Its level of friction.
    pub(super) level: &'a Level,
    /// Depth after depth.
    pub(super) points: Vec<&'a PlanBuckling>,
}

impl Plan {
    /// Every curve: model after model, operation after operation, from the least friction to the
    /// most.
    pub(super) fn curves(&self) -> impl Iterator<Item = Curve<'_>> {
        let models = self.summary.models.iter().copied();
        models.flat_map(move |model| {
            self.operations().flat_map(move |operation| self.curves_of(model, operation))
        })
    }

    /// The curves of a model and an operation, from the least friction to the most.
    pub(super) fn curves_of(
        &self,
        model: ModelKind,
        operation: OperationKind,
    ) -> impl Iterator<Item = Curve<'_>> {
        self.levels.iter().map(move |level| {
            let points = self.summary.curve(model, operation, level.friction).collect();
            Curve { model, operation, level, points }
        })
    }

    /// Weights to buckle: operation after operation, from the least friction to the most.
    pub(super) fn buckling_curves(&self) -> impl Iterator<Item = BucklingCurve<'_>> {
        let operations = [OperationKind::Drill, OperationKind::Slide].into_iter();
        operations.flat_map(move |operation| {
            self.levels.iter().map(move |level| {
                let points = self.summary.buckling.iter().filter(|point| {
                    point.operation == operation && point.friction == level.friction
                });
                BucklingCurve { operation, level, points: points.collect() }
            })
        })
    }
}

/// Hook load without block, N; not a number without an answer.
pub(super) fn hook_load_N(point: &PlanPoint) -> f64 {
    point.scalars.map_or(f64::NAN, |scalars| scalars.hook_load_N)
}

/// Surface torque, N·m; not a number without an answer.
pub(super) fn surface_torque_N_m(point: &PlanPoint) -> f64 {
    point.scalars.map_or(f64::NAN, |scalars| scalars.surface_torque_N_m)
}

/// Weights on bit of a sinusoid and of a helix, N; not a number where no weight buckles the string.
pub(super) fn buckling_weights_N(point: &PlanBuckling) -> [f64; 2] {
    [point.sinusoidal_weight_N, point.helical_weight_N].map(|weight| weight.unwrap_or(f64::NAN))
}

// A picture of a plan over the depth of the bit.

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
