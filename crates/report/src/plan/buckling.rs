//! The weight on bit under which the string begins to buckle.

use super::{BucklingCurve, Plan, figures::over_depth, words::operation_name};
use crate::{
    figure::{Axis, Figure, Ink, Key, Mark, Panel, Range, Sample, Stroke},
    plots::Shown,
};

/// What the string becomes, in the order of the weights.
const SHAPES: [&str; 2] = ["sinusoid", "helix"];

/// Turning to the left, sliding to the right: what is expected as a line, the other frictions as a
/// band around it.
pub(super) fn figure(plan: &Plan, shown: Shown<'_>) -> Option<Figure> {
    let mut operations: Vec<&str> = Vec::new();
    for of in &plan.buckling {
        if !operations.contains(&of.operation.as_str()) {
            operations.push(&of.operation);
        }
    }
    let panels: Vec<Panel> =
        operations.into_iter().map(|operation| panel(plan, shown, operation)).collect();
    let mut keys = Vec::new();
    for (place, name) in SHAPES.iter().enumerate() {
        let ink = Ink::Line(place);
        keys.push(Key { name: (*name).to_owned(), sample: Sample::Line(ink, Stroke::of(place)) });
        let name = format!("{name}, low to high friction");
        keys.push(Key { name, sample: Sample::Band(ink) });
    }
    let subtitle = "least weight on bit under which the string buckles somewhere; soft string";
    let has_rows = panels.iter().any(|panel| !panel.marks.is_empty());
    has_rows.then(|| over_depth(plan, shown, subtitle, keys, panels))
}

fn panel(plan: &Plan, shown: Shown<'_>, operation: &str) -> Panel {
    let curves: Vec<&BucklingCurve> =
        plan.buckling.iter().filter(|of| of.operation == operation).collect();
    let expected = curves.len() / 2;
    let mut marks = Vec::new();
    for shape in 0..SHAPES.len() {
        let value = |of: &BucklingCurve| -> Vec<(f64, f64)> {
            let points = of.points.iter();
            points
                .map(|(depth_m, weights_N)| {
                    (shown.value(*depth_m, "length"), shown.value(weights_N[shape], "force"))
                })
                .collect()
        };
        let ink = Ink::Line(shape);
        if let [first, .., last] = &curves[..] {
            let between = value(first).into_iter().zip(value(last));
            let points = between.map(|((depth, a), (_, b))| (depth, a.min(b), a.max(b)));
            marks.push(Mark::Band { ink, points: points.collect() });
        }
        if let Some(of) = curves.get(expected) {
            marks.push(Mark::Curve { ink, stroke: Stroke::of(shape), points: value(of) });
        }
    }
    if let Some(weight_N) = plan.weight_on_bit_N.filter(|weight| *weight > 0.0) {
        let at = shown.value(weight_N, "force");
        marks.push(Mark::OwnRule { at, label: "the case".to_owned() });
    }
    let title = format!("Weight to buckle, {}", operation_name(operation));
    Panel::new(Axis::new(shown.label(&title, "force"), Range::Zero), marks)
}
