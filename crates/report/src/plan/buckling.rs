//! The weight on bit at which the string begins to buckle.

use super::{
    Plan,
    curves::{BucklingCurve, buckling_weights_N, line, over_depth},
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// Shapes of the buckled string, in the order of the weights.
const SHAPES: [&str; 2] = ["sinusoid", "helix"];

/// A panel for each operation, a line for each friction.
pub(super) fn figure(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let curves: Vec<BucklingCurve<'_>> = plan.buckling_curves().collect();
    let operations = curves.chunk_by(|a, b| a.operation == b.operation);
    let panels: Vec<Panel> = operations.map(|curves| panel(plan, display, curves)).collect();
    let shapes = SHAPES.iter().enumerate().map(|(place, name)| Key {
        name: (*name).to_owned(),
        sample: Sample::Line(Ink::Line(place), Stroke::Solid),
    });
    let levels = plan.levels.iter().map(|level| Key {
        name: format!("{} friction, {}", level.name(), level.label),
        sample: Sample::Line(Ink::Note, level.stroke()),
    });
    let keys = shapes.chain(levels).collect();
    let subtitle = "least weight on bit at which part of the string buckles; soft string";
    let has_rows = panels.iter().any(|panel| !panel.marks.is_empty());
    has_rows.then(|| over_depth(plan, display, subtitle, keys, panels))
}

/// The curves of one operation.
fn panel(plan: &Plan, display: DisplayUnits<'_>, curves: &[BucklingCurve<'_>]) -> Panel {
    let mut marks = Vec::new();
    for curve in curves {
        for shape in 0..SHAPES.len() {
            let points = curve.points.iter().map(|point| {
                let weight_N = buckling_weights_N(point)[shape];
                (display.value(point.bit_depth_m, "length"), display.value(weight_N, "force"))
            });
            let (ink, stroke) = (Ink::Line(shape), curve.level.stroke());
            marks.extend(line(ink, stroke, Shape::of(shape), points.collect()));
        }
    }
    if let Some(weight_N) = plan.summary.weight_on_bit_N().filter(|weight| *weight > 0.0) {
        let at = display.value(weight_N, "force");
        marks.push(Mark::OwnRule { at, label: "the case".to_owned() });
    }
    let operation = curves.first().map_or("", |curve| curve.operation.words());
    let title = format!("Weight to buckle, {operation}");
    Panel::new(Axis::new(display.label(&title, "force"), Range::Zero), marks)
}
