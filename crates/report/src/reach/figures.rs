//! Margins of the limits against the depth of the bit.

use wholestring_judge::DepthLimit;
use wholestring_results::UncertainBand;

use super::{Reach, ReachCurve, is_first, sentences};
use crate::{
    Plot,
    cell::capital,
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::{DisplayUnits, named},
    uncertain::{self, Uncertain},
};

/// Least margin that is drawn, per cent.
const BELOW: f64 = -25.0;

/// A margin that never falls below this is not drawn: its limit is far at every depth.
const FAR: f64 = 0.999;

/// Colours of the limits: those of lines first. Without the beginnings of buckling there are eleven
/// limits, twelve where the string counts as stopped by a helix.
pub(super) const INKS: [Ink; 12] = [
    Ink::Line(0),
    Ink::Line(1),
    Ink::Line(2),
    Ink::Line(3),
    Ink::Line(4),
    Ink::Line(5),
    Ink::Line(6),
    Ink::Rock,
    Ink::Casing,
    Ink::HighSide,
    Ink::LowSide,
    Ink::Text,
];

/// Names of the pictures of a reach.
pub const REACH_PICTURES: [&str; 2] = ["reach", "uncertain"];

/// Returns every picture of a reach, in a set of units (`si`, `metric` or `field`): `uncertain`
/// where several numbers are uncertain.
pub fn reach_plots(reach: &Reach, units: &str) -> Vec<Plot> {
    let is_drawn = !reach.curves.is_empty();
    let margins = is_drawn.then(|| margins(reach, units));
    let owed = reach.uncertain().filter(|_| is_drawn);
    let owed = owed.and_then(|samples| uncertain::figure(samples, &reach.head.title));
    named(REACH_PICTURES, [margins, owed])
}

/// A panel for each operation, a colour for each limit, a stroke for each friction.
fn margins(reach: &Reach, units: &str) -> Figure {
    let display = DisplayUnits::new(&reach.head.dimensions, units);
    let operations = distinct(reach.curves.iter().map(|curve| curve.operation));
    let has_curve = |limit: &DepthLimit| {
        reach.curves.iter().any(|curve| curve.limit == *limit && is_drawn(reach, curve))
    };
    // The order of the colours.
    let drawn: Vec<DepthLimit> = DepthLimit::ALL.into_iter().filter(has_curve).collect();
    let ink = |limit: DepthLimit| {
        let place = drawn.iter().position(|drawn| *drawn == limit);
        place.map_or(Ink::Note, |place| INKS[place % INKS.len()])
    };
    let panels = operations.iter().map(|operation| {
        let mut marks = vec![Mark::OwnRule { at: 0.0, label: String::new() }];
        let scattered = reach.summary.uncertain.iter().flat_map(|uncertain| &uncertain.bands);
        let scattered = scattered.filter(|scattered| {
            scattered.operation == Some(*operation) && !scattered.limit.is_empty()
        });
        marks.extend(scatter(scattered.collect(), display, &ink));
        let curves = reach.curves.iter().filter(|curve| curve.operation == *operation);
        for curve in curves.filter(|curve| is_drawn(reach, curve)) {
            let (ink, stroke) = (ink(curve.limit), Stroke::of(curve.friction));
            marks.push(Mark::Curve { ink, stroke, points: visible(curve, display) });
        }
        for (friction, row) in reach.limits().filter(|(_, limit)| limit.operation == *operation) {
            let Some(depth_m) = row.depth_m else { continue };
            let is_first = is_first(friction, row);
            let points = vec![(display.value(depth_m, "length"), 0.0)];
            let ink = ink(row.limit);
            let shape = if is_first { Shape::Diamond } else { Shape::Circle };
            marks.push(Mark::Points { ink, shape, points: points.clone() });
            if is_first {
                marks.push(Mark::Name { at: points[0], text: row.title.clone() });
            }
        }
        let name = capital(operation.words());
        let axis = Axis::new(format!("{name}: margin, %"), Range::Fixed(BELOW, 105.0));
        Panel::new(axis, marks)
    });
    let key = |limit: &DepthLimit| Key {
        name: limit.title().to_owned(),
        sample: Sample::Line(ink(*limit), Stroke::Solid),
    };
    let mut keys: Vec<Key> = drawn.iter().map(key).collect();
    if reach.has_frictions() {
        for (number, friction) in reach.summary.frictions.iter().enumerate() {
            // Grey, as no limit is: a stroke of any colour.
            let sample = Sample::Line(Ink::Note, Stroke::of(number));
            keys.push(Key { name: sentences::friction(friction), sample });
        }
    }
    if reach.limits().any(|(_, limit)| limit.depth_m.is_some() && begins(reach, limit.limit)) {
        let sample = Sample::Point(Ink::Note, Shape::Circle);
        keys.push(Key { name: "buckling begins".into(), sample });
    }
    if reach.limits().any(|(friction, limit)| is_first(friction, limit)) {
        let sample = Sample::Point(Ink::Text, Shape::Diamond);
        keys.push(Key { name: "stops the well first".into(), sample });
    }
    if reach.uncertain().is_some() {
        keys.push(Key { name: "5 to 95 % of the samples".into(), sample: Sample::Band(Ink::Note) });
    }
    let facts = reach.head.facts.iter().filter_map(|fact| display.fact(fact));
    let ends_m = [reach.summary.from_m, reach.summary.to_m];
    let [from, to] = ends_m.map(|depth_m| display.value(depth_m, "length"));
    Figure {
        title: reach.head.title.clone(),
        subtitle: facts
            .chain(reach.uncertain().map(Uncertain::description))
            .collect::<Vec<_>>()
            .join("; "),
        keys,
        layout: Layout::across(1, 180.0, 48.0),
        shared: Axis::new(
            display.label("Measured depth of the bit", "length"),
            Range::Fixed(from, to),
        ),
        panels: panels.collect(),
        hole: Vec::new(),
    }
}

/// Bands of the margins, then the spread of the depths where these are zero.
fn scatter(
    numbers: Vec<&UncertainBand>,
    display: DisplayUnits<'_>,
    ink: &impl Fn(DepthLimit) -> Ink,
) -> Vec<Mark> {
    let ink_of = |band: &UncertainBand| DepthLimit::named(&band.limit).map_or(Ink::Note, ink);
    let mut marks: Vec<Mark> = Vec::new();
    let mut last = None;
    for margin in numbers.iter().filter(|number| number.quantity == "margin") {
        let [low, .., high] = margin.quantiles.map(|part| (100.0 * part).max(BELOW));
        let depth = display.value(margin.bit_depth_m.unwrap_or(f64::NAN), "length");
        let key = (&margin.limit, margin.friction.map(f64::to_bits));
        if last != Some(key) {
            marks.push(Mark::Band { ink: ink_of(margin), points: Vec::new() });
            last = Some(key);
        }
        if let Some(Mark::Band { points, .. }) = marks.last_mut() {
            points.push((depth, low, high));
        }
    }
    for depth in numbers
        .iter()
        .filter(|number| number.quantity == "depth" && number.not_met < number.answers)
    {
        let [from, .., to] = depth.quantiles.map(|depth_m| (display.value(depth_m, "length"), 0.0));
        marks.push(Mark::Bars { ink: ink_of(depth), bars: vec![[from, to]] });
    }
    marks
}

/// Whether a curve falls at all, or its string is locked up. Buckling that the string survives has
/// a point where it begins, and no curve.
fn is_drawn(reach: &Reach, curve: &ReachCurve) -> bool {
    let falls = curve.points.iter().any(|(_, margin)| margin.is_nan() || *margin < FAR);
    falls && !begins(reach, curve.limit)
}

/// Whether a limit is the beginning of buckling that stops no operation.
fn begins(reach: &Reach, limit: DepthLimit) -> bool {
    !limit.stops() && !reach.limits().any(|(_, row)| row.limit == limit && row.stops)
}

/// A curve up to the edge of the frame, per cent.
fn visible(curve: &ReachCurve, display: DisplayUnits<'_>) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (depth_m, margin) in &curve.points {
        let (depth, percent) = (display.value(*depth_m, "length"), 100.0 * margin);
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

/// Each name once, in the order of the first occurrence.
fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for one in all {
        if !found.contains(&one) {
            found.push(one);
        }
    }
    found
}
