//! Places of findings, and the points that they concern: light over a stretch, a bar at its edge, a
//! ring about a point.
//!
//! Less severe findings have broken bars and rings, so that they are distinguished without colour.

use super::place::Place;
use crate::{
    Severity,
    draw::{Drawing, Ink, Pen},
};

/// Opacity of a stretch.
const GROUND: f64 = 0.1;
/// Width of a bar, points, and its least length.
const BAR: f64 = 2.6;
const MIN: f64 = 1.4;
/// Pieces of a broken bar, and the gaps between them, points.
const PIECE: f64 = 4.0;
const GAP: f64 = 2.0;
/// Radius of a ring, points: about any shape of a point.
const RING: f64 = 3.8;

fn ink(level: Severity) -> Ink {
    match level {
        Severity::Error => Ink::Error,
        Severity::Warning => Ink::Warning,
        Severity::Note | Severity::Ok => Ink::Note,
    }
}

/// A stretch of the shared axis over the whole frame.
pub(super) fn stretch(
    on: &mut Drawing,
    level: Severity,
    (from, to): (f64, f64),
    place: &Place<'_>,
) {
    let (start, end) = place.shared.ends();
    let is_point = from == to;
    let (from, to) = (from.max(start.min(end)), to.min(start.max(end)));
    if from > to || !(from + to).is_finite() {
        return;
    }
    let [a, b] = place.shared_line(from);
    let [d, c] = place.shared_line(to);
    if !is_point {
        on.fill(vec![a, b, c, d], ink(level), GROUND);
    }
    // Depth points down and the bar is at the right; an axis across has it at the foot.
    let far = if place.down { [b, c] } else { [(b.0, b.1.max(a.1)), (c.0, c.1.max(d.1))] };
    bar(on, level, far, place.down);
}

/// A bar from one end to the other, broken where the finding is not an error.
fn bar(on: &mut Drawing, level: Severity, [from, to]: [(f64, f64); 2], down: bool) {
    let (first, last) = if down { (from.1, to.1) } else { (from.0, to.0) };
    let (first, last) = (first.min(last), first.max(last).max(first.min(last) + MIN));
    if !(last - first).is_finite() {
        return;
    }
    let piece = match level {
        Severity::Error => last - first,
        Severity::Warning | Severity::Note | Severity::Ok => PIECE,
    };
    let edge = if down { from.0 } else { from.1 };
    let mut outlines = Vec::new();
    let mut at = first;
    while at < last {
        let end = (at + piece).min(last);
        let corners = [(edge - BAR, at), (edge, at), (edge, end), (edge - BAR, end)];
        outlines.push(corners.map(|(x, y)| if down { (x, y) } else { (y, x) }).to_vec());
        at = end + GAP;
    }
    on.path(outlines, true, Some((ink(level), 1.0)), None);
}

/// The sample of a legend: a stretch with its bar.
pub(super) fn sample(
    on: &mut Drawing,
    level: Severity,
    (left, top): (f64, f64),
    (width, height): (f64, f64),
) {
    let (right, bottom) = (left + width, top + height);
    let corners = vec![(left, top), (right, top), (right, bottom), (left, bottom)];
    on.fill(corners, ink(level), 2.0 * GROUND);
    bar(on, level, [(right, top), (right, bottom)], true);
}

/// A ring about a point.
pub(super) fn ring(on: &mut Drawing, level: Severity, (x, y): (f64, f64)) {
    const CORNERS: usize = 24;
    if !(x + y).is_finite() {
        return;
    }
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / CORNERS as f64;
        (x + RING * angle.sin(), y - RING * angle.cos())
    };
    let dash = match level {
        Severity::Error => None,
        Severity::Warning | Severity::Note | Severity::Ok => Some([1.6, 1.4]),
    };
    let pen = Pen { dash, ..Pen::new(ink(level), 0.9) };
    on.path(vec![(0..CORNERS).map(corner).collect()], true, None, Some(pen));
}
