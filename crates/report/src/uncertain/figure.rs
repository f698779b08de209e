//! Which inputs the samples owe their scatter to, as bars.

use super::{Uncertain, UncertainNumber};
use crate::{
    figure::{Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Scale, Shape},
    operation_words::{colour, operation_name},
};

/// What bars are drawn of, and the heading of their panel.
const DRAWN: [(&str, &str); 3] = [
    ("hook_load", "Hook load"),
    ("surface_torque", "Surface torque"),
    ("depth", "Depth of the first stop"),
];

/// Part of the room of an input that its bars take.
const FULL: f64 = 0.8;

/// Less than this part of the variance is no bar that anybody sees.
const SEEN: f64 = 0.005;

/// A row for each input, a bar for each operation: its length is the total index, the point on it the
/// first-order one. None of a single input, which has all.
pub(crate) fn figure(of: &Uncertain, title: &str) -> Option<Figure> {
    if of.inputs.len() < 2 {
        return None;
    }
    let mut operations: Vec<&str> = Vec::new();
    let mut panels = Vec::new();
    for (quantity, heading) in DRAWN {
        let is_drawn = |one: &&UncertainNumber| {
            one.quantity == quantity && one.owed.is_some() && one.limit.is_empty()
        };
        let drawn: Vec<&UncertainNumber> = of.told().filter(is_drawn).collect();
        if drawn.is_empty() {
            continue;
        }
        for one in &drawn {
            if !operations.contains(&one.operation.as_str()) {
                operations.push(&one.operation);
            }
        }
        let axis = Axis::new(format!("{heading}, %"), Range::Fixed(0.0, 100.0));
        panels.push(Panel::new(axis, bars(&drawn)));
    }
    if panels.is_empty() {
        return None;
    }
    let named = operations
        .iter()
        .filter(|of| !of.is_empty())
        .map(|of| Key { name: operation_name(of), sample: Sample::Band(Ink::Line(colour(of))) });
    let what = [
        Key { name: "bar: total index".into(), sample: Sample::Words },
        Key { name: "first-order index".into(), sample: Sample::Point(Ink::Text, Shape::Circle) },
    ];
    let keys: Vec<Key> = named.chain(what).collect();
    let words = of.inputs.iter().map(|[key, _]| key.clone()).collect();
    Some(Figure {
        title: title.to_owned(),
        subtitle: of.said(),
        keys,
        layout: Layout {
            direction: Direction::Down,
            columns: panels.len(),
            width_mm: 180.0,
            panel_mm: 14.0 * (of.inputs.len() as f64).max(2.0),
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

fn bars(drawn: &[&UncertainNumber]) -> Vec<Mark> {
    let mut marks = Vec::new();
    let height = FULL / drawn.len() as f64;
    for (place, of) in drawn.iter().enumerate() {
        let Some(owed) = &of.owed else { continue };
        let ink = Ink::Line(colour(&of.operation));
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
            let points = vec![(at, 100.0 * first.clamp(0.0, 1.0))];
            marks.push(Mark::Points { ink, shape: Shape::Circle, points });
        }
    }
    marks
}
