//! Margins of the limits against the depth of the bit.

use super::{Reach, ReachCurve};
use crate::{
    Plot,
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::Shown,
};

/// How far below zero a margin is drawn, per cent.
const BELOW: f64 = -25.0;

/// Colours of the limits: those of lines first, for there are seldom more limits than these.
pub(super) const INKS: [Ink; 9] = [
    Ink::Line(0),
    Ink::Line(1),
    Ink::Line(2),
    Ink::Line(3),
    Ink::Line(4),
    Ink::Line(5),
    Ink::Line(6),
    Ink::Rock,
    Ink::Casing,
];

/// Every picture of a reach, in a set of units (`si`, `metric` or `field`): `reach`.
pub fn reach_plots(reach: &Reach, units: &str) -> Vec<Plot> {
    if reach.curves.is_empty() {
        return Vec::new();
    }
    vec![Plot { name: "reach".into(), figure: margins(reach, units) }]
}

/// A panel for each operation, a colour for each limit, a stroke for each friction.
fn margins(reach: &Reach, units: &str) -> Figure {
    let shown = Shown::new(&reach.head.dimensions, units);
    let operations = distinct(reach.curves.iter().map(|of| of.operation.as_str()));
    let drawn_titles: Vec<&String> = reach
        .titles
        .iter()
        .filter(|of| reach.curves.iter().any(|curve| curve.limit == **of))
        .collect();
    let ink = |limit: &str| {
        let place = drawn_titles.iter().position(|of| *of == limit);
        INKS[place.unwrap_or(0) % INKS.len()]
    };
    let panels = operations.iter().map(|operation| {
        let mut marks = vec![Mark::OwnRule { at: 0.0, label: String::new() }];
        for curve in reach.curves.iter().filter(|of| of.operation == *operation) {
            let (ink, stroke) = (ink(&curve.limit), Stroke::of(curve.friction));
            marks.push(Mark::Curve { ink, stroke, points: drawn(curve, shown) });
        }
        for row in reach.limits.iter().filter(|of| of.operation == *operation) {
            let Some(depth_m) = row.depth_m else { continue };
            let points = vec![(shown.value(depth_m, "length"), 0.0)];
            let ink = ink(&row.limit);
            let shape = if row.first { Shape::Diamond } else { Shape::Circle };
            marks.push(Mark::Points { ink, shape, points: points.clone() });
            if row.first {
                marks.push(Mark::Name { at: points[0], text: row.limit.clone() });
            }
        }
        let mut letters = operation.chars();
        let first = letters.next().map(|letter| letter.to_uppercase().to_string());
        let name = first.unwrap_or_default() + letters.as_str();
        let axis = Axis::new(format!("{name}: margin, %"), Range::Fixed(BELOW, 105.0));
        Panel::new(axis, marks)
    });
    let key = |limit: &&String| Key {
        name: (*limit).clone(),
        sample: Sample::Line(ink(limit), Stroke::Solid),
    };
    let mut keys: Vec<Key> = drawn_titles.iter().map(key).collect();
    if reach.frictions.len() > 1 {
        for (number, friction) in reach.frictions.iter().enumerate() {
            let sample = Sample::Line(Ink::Text, Stroke::of(number));
            keys.push(Key { name: friction.clone(), sample });
        }
    }
    if reach.limits.iter().any(|of| of.first) {
        let sample = Sample::Point(Ink::Text, Shape::Diamond);
        keys.push(Key { name: "stops the well first".into(), sample });
    }
    let facts = reach.head.facts.iter().filter_map(|fact| shown.fact(fact));
    let [from, to] = reach.depths_m.map(|depth_m| shown.value(depth_m, "length"));
    Figure {
        title: reach.head.title.clone(),
        subtitle: facts.collect::<Vec<_>>().join("; "),
        keys,
        layout: Layout::across(1, 180.0, 48.0),
        shared: Axis::new(
            shown.label("Measured depth of the bit", "length"),
            Range::Fixed(from, to),
        ),
        panels: panels.collect(),
        hole: Vec::new(),
    }
}

/// A curve down to where it leaves the frame, per cent.
fn drawn(curve: &ReachCurve, shown: Shown<'_>) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (depth_m, margin) in &curve.points {
        let (depth, percent) = (shown.value(*depth_m, "length"), 100.0 * margin);
        match points.last() {
            Some((before, above)) if percent < BELOW && *above >= BELOW => {
                let part = (above - BELOW) / (above - percent);
                points.push((before + part * (depth - before), BELOW));
                points.push((depth, f64::NAN));
            }
            _ if percent < BELOW => points.push((depth, f64::NAN)),
            _ => points.push((depth, percent)),
        }
    }
    points
}

/// Each once, in the order of the first.
fn distinct<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for one in all {
        if !found.contains(&one) {
            found.push(one);
        }
    }
    found
}
