//! The weight on bit at which the string begins to buckle.

use wholestring::operation::OperationKind;

use super::{
    Plan,
    broomstick::STROKES,
    depth_figure::{line, over_depth},
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// Shapes of the buckled string, in the order of the weights.
const SHAPES: [&str; 2] = ["sinusoid", "helix"];

/// A panel for each operation, a line for each friction.
pub(super) fn figure(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let mut operations: Vec<OperationKind> = Vec::new();
    for curve in &plan.buckling {
        if !operations.contains(&curve.operation) {
            operations.push(curve.operation);
        }
    }
    let panels: Vec<Panel> =
        operations.into_iter().map(|operation| panel(plan, display, operation)).collect();
    let shapes = SHAPES.iter().enumerate().map(|(place, name)| Key {
        name: (*name).to_owned(),
        sample: Sample::Line(Ink::Line(place), Stroke::Solid),
    });
    let levels = plan.levels.iter().zip(STROKES).map(|(level, stroke)| Key {
        name: format!("{} friction, {}", level.name, level.label),
        sample: Sample::Line(Ink::Note, stroke),
    });
    let keys = shapes.chain(levels).collect();
    let subtitle = "least weight on bit at which part of the string buckles; soft string";
    let has_rows = panels.iter().any(|panel| !panel.marks.is_empty());
    has_rows.then(|| over_depth(plan, display, subtitle, keys, panels))
}

fn panel(plan: &Plan, display: DisplayUnits<'_>, operation: OperationKind) -> Panel {
    let curves = plan.buckling.iter().filter(|buckling| buckling.operation == operation);
    let mut marks = Vec::new();
    for curve in curves {
        for shape in 0..SHAPES.len() {
            let points = curve.points.iter().map(|(depth_m, weights_N)| {
                (display.value(*depth_m, "length"), display.value(weights_N[shape], "force"))
            });
            let (ink, stroke) = (Ink::Line(shape), STROKES[curve.level % STROKES.len()]);
            marks.extend(line(ink, stroke, Shape::of(shape), points.collect()));
        }
    }
    if let Some(weight_N) = plan.weight_on_bit_N.filter(|weight| *weight > 0.0) {
        let at = display.value(weight_N, "force");
        marks.push(Mark::OwnRule { at, label: "the case".to_owned() });
    }
    let title = format!("Weight to buckle, {}", operation.words());
    Panel::new(Axis::new(display.label(&title, "force"), Range::Zero), marks)
}
