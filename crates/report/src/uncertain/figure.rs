//! Sensitivity of the samples to the inputs (Sobol indices), as bars.

use wholestring::operation::OperationKind;
use wholestring_results::UncertainBand;

use super::Uncertain;
use crate::{
    draw::palette::operation_colour,
    figure::{Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Scale, Shape},
};

/// Quantities with bars, and the heading of their panel.
const DRAWN: [(&str, &str); 3] = [
    ("hook_load", "Hook load"),
    ("surface_torque", "Surface torque"),
    ("depth", "Depth of the first stop"),
];

/// Part of an input's height that its bars take.
const FULL: f64 = 0.8;

/// A bar below this part of the variance is invisible.
const SEEN: f64 = 0.005;

/// A row for each input, a bar for each operation: its length is the total index, the point on it
/// the first-order one. `None` for a single input, which has all.
pub(crate) fn figure(uncertain: Uncertain<'_>, title: &str) -> Option<Figure> {
    let inputs = &uncertain.summary.inputs;
    if inputs.len() < 2 {
        return None;
    }
    let mut operations: Vec<OperationKind> = Vec::new();
    let mut panels = Vec::new();
    for (quantity, heading) in DRAWN {
        let is_drawn = |one: &&UncertainBand| {
            one.quantity == quantity && one.owed.is_some() && one.limit.is_empty()
        };
        let numbers: Vec<&UncertainBand> = uncertain.listed().filter(is_drawn).collect();
        if numbers.is_empty() {
            continue;
        }
        for one in &numbers {
            operations.extend(one.operation.filter(|operation| !operations.contains(operation)));
        }
        let axis = Axis::new(format!("{heading}, %"), Range::Fixed(0.0, 100.0));
        panels.push(Panel::new(axis, bars(&numbers)));
    }
    if panels.is_empty() {
        return None;
    }
    let named = operations.iter().map(|operation| Key {
        name: operation.words().to_owned(),
        sample: Sample::Band(Ink::Line(operation_colour(*operation))),
    });
    let what = [
        Key { name: "bar: total index".into(), sample: Sample::Words },
        Key { name: "first-order index".into(), sample: Sample::Point(Ink::Text, Shape::Circle) },
    ];
    let keys: Vec<Key> = named.chain(what).collect();
    let words = inputs.iter().map(|input| input.key.clone()).collect();
    Some(Figure {
        title: title.to_owned(),
        subtitle: uncertain.description(),
        keys,
        layout: Layout {
            direction: Direction::Down,
            columns: panels.len(),
            width_mm: 180.0,
            panel_mm: 14.0 * (inputs.len() as f64).max(2.0),
        },
        shared: Axis {
            scale: Scale::Words(words),
            down: true,
            ..Axis::new(String::new(), Range::Tight)
        },
        panels,
        hole: Vec::new(),
    })
}

fn bars(numbers: &[&UncertainBand]) -> Vec<Mark> {
    let mut marks = Vec::new();
    let height = FULL / numbers.len() as f64;
    for (place, number) in numbers.iter().enumerate() {
        let Some(owed) = &number.owed else { continue };
        // Numbers of no operation, as the depth of the first stop of all, have the last colour.
        let ink = Ink::Line(number.operation.map_or(Ink::LINES - 1, operation_colour));
        let middle = (place as f64 + 0.5) * height - 0.5 * FULL;
        for (input, (first, total)) in owed.first.iter().zip(&owed.total).enumerate() {
            if *total < SEEN {
                continue;
            }
            let at = input as f64 + middle;
            let half = 0.45 * height;
            let long = 100.0 * total.clamp(0.0, 1.0);
            marks.push(Mark::Band {
                ink,
                points: vec![(at - half, 0.0, long), (at + half, 0.0, long)],
            });
            let points = vec![(at, 100.0 * first.unwrap_or(f64::NAN).clamp(0.0, 1.0))];
            marks.push(Mark::Points { ink, shape: Shape::Circle, points });
        }
    }
    marks
}
