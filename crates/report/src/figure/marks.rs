//! Drawing of the marks of a panel.

use super::{Map, Mark, Shape, Stroke, found, names::crowd, place::Place};
use crate::draw::{
    Anchor, Box, ColourScale, Drawing, Hue, Image, Ink, Pen, envelope, text_width, thinned,
};

/// Width of a curve, points.
pub(crate) const CURVE: f64 = 0.9;

/// Opacity of a band.
pub(crate) const BAND: f64 = 0.22;

/// Points closer than this along a curve cannot be distinguished.
const CLOSE: f64 = 0.12;

pub(super) fn pen(ink: Ink, stroke: Stroke) -> Pen {
    Pen { dash: stroke.dash(), ..Pen::new(ink, CURVE) }
}

/// A single point.
pub(super) fn shape(on: &mut Drawing, shape: Shape, at: (f64, f64), ink: Ink) {
    shapes(on, vec![outline(shape, at)], ink);
}

/// Points of one kind, as one path: a sweep has hundreds.
fn shapes(on: &mut Drawing, outlines: Vec<Vec<(f64, f64)>>, ink: Ink) {
    on.path(outlines, true, Some((ink, 1.0)), Some(Pen::new(Ink::Paper, 0.4)));
}

fn outline(shape: Shape, (x, y): (f64, f64)) -> Vec<(f64, f64)> {
    let corners = |count: usize, radius: f64, turn: f64| -> Vec<(f64, f64)> {
        (0..count)
            .map(|i| {
                let angle = turn + std::f64::consts::TAU * i as f64 / count as f64;
                (x + radius * angle.sin(), y - radius * angle.cos())
            })
            .collect()
    };
    let half_turn = std::f64::consts::PI;
    match shape {
        Shape::Circle => corners(12, 1.7, 0.0),
        Shape::Square => corners(4, 2.2, half_turn / 4.0),
        Shape::Triangle => corners(3, 2.3, 0.0),
        Shape::Diamond => corners(4, 2.3, 0.0),
        Shape::Tip => corners(3, 2.3, half_turn),
    }
}

/// Draws a mark at its place, among all those of its panel.
pub(super) fn draw(on: &mut Drawing, mark: &Mark, all: &[Mark], place: &Place) {
    match mark {
        Mark::Curve { ink, stroke, points } => {
            let pieces = pieces(points, place);
            let pieces = pieces.into_iter().filter(|piece| piece.len() > 1);
            on.path(pieces.collect(), false, None, Some(pen(*ink, *stroke)));
        }
        Mark::Band { ink, points } => {
            for piece in points.split(|(shared, low, high)| !(shared + low + high).is_finite()) {
                band(on, piece, (*ink, BAND), place);
            }
        }
        Mark::Sides { points } => {
            for (ink, keep) in
                [(Ink::HighSide, f64::max as fn(f64, f64) -> f64), (Ink::LowSide, f64::min)]
            {
                let area = points.iter().map(|(shared, own)| (*shared, 0.0, keep(*own, 0.0)));
                for piece in
                    area.collect::<Vec<_>>().split(|(shared, _, own)| !(shared + own).is_finite())
                {
                    band(on, piece, (ink, 1.0), place);
                }
            }
        }
        Mark::Points { ink, shape: form, points } => {
            let places = points.iter().map(|point| place.of(*point));
            let places = places.filter(|(x, y)| (x + y).is_finite());
            let outlines: Vec<_> = places.map(|at| outline(*form, at)).collect();
            if !outlines.is_empty() {
                shapes(on, outlines, *ink);
            }
        }
        Mark::Bars { ink, bars } => {
            for [from, to] in bars {
                bar(on, place.of(*from), place.of(*to), *ink);
            }
        }
        Mark::SharedRule { at, label } => rule(on, place.shared_line(*at), label, all, place),
        Mark::OwnRule { at, label } => rule(on, place.own_line(*at), label, all, place),
        Mark::Shade { from, to } => {
            let [a, b] = place.shared_line(*from);
            let [d, c] = place.shared_line(*to);
            on.fill(vec![a, b, c, d], Ink::Settling, 1.0);
        }
        Mark::Found { level, from, to } => found::stretch(on, *level, (*from, *to), place),
        Mark::Rings { level, points } => {
            for point in points {
                found::ring(on, *level, place.of(*point));
            }
        }
        Mark::Map(map) => on.image(image(map, place), place.frame),
        Mark::Spots { points, rows } => {
            let spots = points.iter().zip(rows);
            let spots = spots.map(|(point, row)| (place.of(*point), *row));
            on.spots(spots.filter(|((x, y), _)| (x + y).is_finite()).collect());
        }
        // The panel places names where there is room, and handles groups of keys.
        Mark::Name { .. } | Mark::Foot { .. } | Mark::Of { .. } => {}
    }
}

/// The curve in pieces of finite points, with no more of them than can be seen.
fn pieces(points: &[(f64, f64)], place: &Place) -> Vec<Vec<(f64, f64)>> {
    let on_page: Vec<_> = points.iter().map(|point| place.of(*point)).collect();
    on_page
        .split(|(x, y)| !(x + y).is_finite())
        .map(|piece| thinned(&envelope(piece, CLOSE, place.down)))
        .collect()
}

/// The area between two curves.
fn band(on: &mut Drawing, points: &[(f64, f64, f64)], (ink, opacity): (Ink, f64), place: &Place) {
    let edge = |own: fn(&(f64, f64, f64)) -> f64| {
        let points: Vec<_> = points.iter().map(|point| (point.0, own(point))).collect();
        pieces(&points, place).concat()
    };
    let mut outline = edge(|point| point.1);
    outline.extend(edge(|point| point.2).into_iter().rev());
    if outline.len() > 3 {
        on.fill(outline, ink, opacity);
    }
}

/// A line between two ends that are marked.
pub(super) fn bar(on: &mut Drawing, from: (f64, f64), to: (f64, f64), ink: Ink) {
    /// Half of a mark at an end, points.
    const END: f64 = 1.6;
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    if !(length > 0.0 && length.is_finite()) {
        return;
    }
    let (x, y) = (END * (to.1 - from.1) / length, END * (to.0 - from.0) / length);
    let end = |at: (f64, f64)| vec![(at.0 - x, at.1 + y), (at.0 + x, at.1 - y)];
    let lines = vec![vec![from, to], end(from), end(to)];
    on.path(lines, false, None, Some(Pen::new(ink, 0.5)));
}

/// A dashed line with its name, where few curves run, on a ground of paper, because it may be over
/// a map.
fn rule(on: &mut Drawing, line: [(f64, f64); 2], label: &str, all: &[Mark], place: &Place) {
    const SIZE: f64 = 6.5;
    on.line(&line, Pen::new(Ink::Paper, 1.4));
    on.line(&line, Pen { dash: Some([2.0, 1.6]), ..Pen::new(Ink::Note, 0.6) });
    if label.is_empty() {
        return;
    }
    let width = text_width(label, SIZE);
    let [(left, y), (right, other)] = line;
    let ground = |(left, y): (f64, f64)| Box {
        left: left - 1.5,
        top: y - 4.0,
        width: width + 3.0,
        height: 8.0,
    };
    let at = if y == other {
        let ends = [right - width - 4.0, left + 4.0];
        let places = [-6.5, 6.5].map(|off| ends.map(|left| (left, y + off)));
        let within = |at: &(f64, f64)| {
            let ground = ground(*at);
            ground.top >= place.frame.top && ground.bottom() <= place.frame.bottom()
        };
        let free = places.concat().into_iter().filter(within);
        let free = free.min_by_key(|at| crowd(&ground(*at), all, place));
        free.unwrap_or(places[0][0])
    } else {
        let row = row(label, left, all, place) as f64;
        (beside(left, width, place), y.min(other) + 7.0 + 9.0 * row)
    };
    on.fill(ground(at).corners().to_vec(), Ink::Paper, 0.75);
    on.text(label, at, SIZE, Ink::Text, Anchor::Start);
}

/// Left edge of a name next to a line down the page: to its right, where there is room.
fn beside(x: f64, width: f64, place: &Place) -> f64 {
    let right = x + 3.5;
    if right + width <= place.frame.right() { right } else { x - 3.5 - width }
}

/// The row of a name next to a line down the page: the first where it covers no name of an earlier
/// line.
fn row(label: &str, x: f64, all: &[Mark], place: &Place) -> usize {
    let lines = all.iter().filter_map(|mark| {
        let (line, label) = match mark {
            Mark::OwnRule { at, label } => (place.own_line(*at), label),
            Mark::SharedRule { at, label } => (place.shared_line(*at), label),
            _ => return None,
        };
        let [(x, top), (_, bottom)] = line;
        (top != bottom && !label.is_empty()).then_some((x, label))
    });
    let mut taken: Vec<(usize, f64, f64)> = Vec::new();
    for (at, name) in lines {
        let width = text_width(name, 6.5);
        let left = beside(at, width, place);
        let right = left + width + 3.0;
        let covers = |row: usize| {
            taken.iter().any(|(other, from, to)| *other == row && left < *to && *from < right)
        };
        let row = (0..).find(|row| !covers(*row)).unwrap_or(0);
        if at == x && name == label {
            return row;
        }
        taken.push((row, left, right));
    }
    0
}

/// Colours as pixels: as many as there are values where those are few, and no more than can be
/// printed.
fn image(map: &Map, place: &Place) -> Image {
    /// Pixels per point on the page.
    const FINE: f64 = 3.0;
    let Box { width, height, .. } = place.frame;
    let [columns, rows] = [width, height].map(|points| (points * FINE).ceil().max(1.0) as usize);
    let scale = ColourScale::new(map.hue);
    let stretches = map.middles.len();
    let pixels = (0..rows).flat_map(|row| {
        let own = place.own_at((row as f64 + 0.5) / rows as f64);
        let nearest = nearest(&map.middles, own);
        let scale = &scale;
        (0..columns).map(move |column| {
            let shared = place.shared_at((column as f64 + 0.5) / columns as f64);
            let moment = map.ends.partition_point(|end| *end < shared);
            let value = map.values.get(moment * stretches + nearest);
            let value = value.copied().filter(|value| value.is_finite())?;
            let part = value / map.largest;
            Some(scale.at(match map.hue {
                Hue::Side => 0.5 + 0.5 * part,
                Hue::Amount | Hue::Depth => part,
            }))
        })
    });
    Image { columns, pixels: pixels.collect() }
}

/// The place of the nearest of some increasing values.
fn nearest(values: &[f64], to: f64) -> usize {
    let above = values.partition_point(|value| *value < to);
    let below = above.saturating_sub(1);
    match values.get(above) {
        Some(value) if value - to < to - values[below] => above,
        _ => below,
    }
}
