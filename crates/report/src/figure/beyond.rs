//! Values beyond the ends of an axis that leaves outliers out.

use super::{Mark, place::Place};
use crate::draw::{Anchor, Drawing, Ink, text_width};

/// Length of an arrow, points.
const ARROW: f64 = 4.0;
/// Half of its width.
const HALF: f64 = 2.2;
const SIZE: f64 = 6.5;

/// A point beyond an end: shared and own value.
type Point = (f64, f64);

/// Draws an arrow at the edge for the outermost point of every run of points beyond it, and the
/// value in numbers at the outermost of all.
pub(super) fn draw(on: &mut Drawing, marks: &[Mark], place: &Place<'_>) {
    let (from, to) = place.own.ends();
    for high in [false, true] {
        let outside = |own: f64| if high { own > to } else { own < from };
        let outer = |a: &Point, b: &Point| {
            let order = a.1.total_cmp(&b.1);
            if high { order } else { order.reverse() }
        };
        let mut outermost: Option<(Point, Ink)> = None;
        for (points, ink) in marks.iter().filter_map(points) {
            for run in points.split(|(_, own)| !outside(*own)) {
                let Some(point) = run.iter().copied().max_by(outer) else {
                    continue;
                };
                arrow(on, place, point.0, high, ink);
                if outermost.is_none_or(|(other, _)| outer(&other, &point).is_lt()) {
                    outermost = Some((point, ink));
                }
            }
        }
        if let Some(((shared, own), _)) = outermost {
            label(on, place, shared, high, &place.own.text(own));
        }
    }
}

/// The points of a curve, or single ones, and their colour.
fn points(mark: &Mark) -> Option<(&[Point], Ink)> {
    match mark {
        Mark::Curve { ink, points, .. } | Mark::Points { ink, points, .. } => {
            Some((&points[..], *ink))
        }
        _ => None,
    }
}

/// The tip of an arrow at the edge of the frame, and the direction that it points to.
fn tip(place: &Place<'_>, shared: f64, high: bool) -> ((f64, f64), (f64, f64)) {
    let [start, end] = place.shared_line(shared);
    if place.down {
        // The panel's own axis points to the right.
        if high { (end, (1.0, 0.0)) } else { (start, (-1.0, 0.0)) }
    } else if high != place.own_down {
        (start, (0.0, -1.0))
    } else {
        (end, (0.0, 1.0))
    }
}

fn arrow(on: &mut Drawing, place: &Place<'_>, shared: f64, high: bool, ink: Ink) {
    let ((x, y), (dx, dy)) = tip(place, shared, high);
    if !(x + y).is_finite() {
        return;
    }
    let (back_x, back_y) = (x - ARROW * dx, y - ARROW * dy);
    let corners = vec![
        (x, y),
        (back_x + HALF * dy, back_y + HALF * dx),
        (back_x - HALF * dy, back_y - HALF * dx),
    ];
    on.fill(corners, ink, 1.0);
}

/// The value, on a ground of paper next to its arrow.
fn label(on: &mut Drawing, place: &Place<'_>, shared: f64, high: bool, text: &str) {
    let ((x, y), (dx, dy)) = tip(place, shared, high);
    let frame = place.frame;
    let width = text_width(text, SIZE);
    let (left, middle) = if dx == 0.0 {
        let right = x + HALF + 2.0;
        let left = if right + width > frame.right() { x - HALF - 2.0 - width } else { right };
        (left, y - dy * 5.0)
    } else {
        let left = if high { x - ARROW - 2.0 - width } else { x + ARROW + 2.0 };
        (left, y.clamp(frame.top + 4.0, frame.bottom() - 4.0))
    };
    if !(left + middle).is_finite() {
        return;
    }
    let (top, bottom) = (middle - 4.0, middle + 4.0);
    let right = left + width;
    let ground =
        vec![(left - 1.0, top), (right + 1.0, top), (right + 1.0, bottom), (left - 1.0, bottom)];
    on.fill(ground, Ink::Paper, 0.75);
    on.text(text, (left, middle), SIZE, Ink::Text, Anchor::Start);
}
