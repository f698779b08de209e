//! Names in a panel, each where it covers no other and few curves.

use super::{Mark, place::Place};
use crate::draw::{Anchor, Box, Drawing, Ink, Pen, text_width};

/// Size of names, points, and the height of one.
const SIZE: f64 = 6.5;
const HEIGHT: f64 = 8.0;

/// Between a name and the end of its curve, points.
const GAP: f64 = 3.0;

/// Between a frame and the names next to it, points: room for the lines to names that are moved.
const MARGIN_GAP: f64 = 8.0;

/// A name that is farther from its point than this has a line to it, points.
const FAR: f64 = 4.5;

/// Curves that end within this many points of each other have their names in one row or column.
const TOGETHER: f64 = 8.0;

/// A name, the point that it belongs to, and the keys of the legend that hide both.
struct Named<'a> {
    at: (f64, f64),
    text: &'a str,
    keys: &'a [usize],
    /// Whether it is the name of a curve, at the end of it.
    ends: bool,
}

impl Named<'_> {
    fn width(&self) -> f64 {
        width(self.text)
    }
}

/// Width of a name, points.
fn width(text: &str) -> f64 {
    text_width(text, SIZE) + 2.0
}

/// Width of the space next to a frame that the name of a curve needs, points.
pub(super) fn margin(text: &str) -> f64 {
    MARGIN_GAP + width(text) + 2.0
}

/// Draws all names of a panel: those of curves at their ends, in the order of the ends, and those
/// of points next to them. Names of keys of the legend are grouped with them.
pub(super) fn names(on: &mut Drawing, all: &[Mark], place: &Place) {
    let mut taken: Vec<Box> = Vec::new();
    let (ends, mut points): (Vec<Named>, Vec<Named>) =
        named(all, place).into_iter().partition(|name| name.ends);
    let ends = if place.margin.is_some() { ends } else { Vec::new() };
    for group in together(ends, place.down) {
        match at_ends(&group, all, place, &taken) {
            Some(rooms) => {
                for (name, room) in group.iter().zip(rooms) {
                    taken.push(room);
                    draw(on, name, room, all, place);
                }
            }
            // More names than fit in a row.
            None => points.extend(group),
        }
    }
    for name in &points {
        if let Some(room) = beside(name, &points, all, place, &taken) {
            taken.push(room);
            draw(on, name, room, all, place);
        }
    }
}

/// The names of a panel whose points have a place on it.
fn named<'a>(all: &'a [Mark], place: &Place) -> Vec<Named<'a>> {
    let mut keys: &[usize] = &[];
    let mut found = Vec::new();
    for mark in all {
        let (at, text, ends) = match mark {
            Mark::Of { keys: next } => {
                keys = next;
                continue;
            }
            Mark::Name { at, text } => (place.of(*at), text, false),
            Mark::Foot { at, text } => (place.of(*at), text, true),
            _ => continue,
        };
        if (at.0 + at.1).is_finite() {
            found.push(Named { at, text, keys, ends });
        }
    }
    found
}

/// Names of curves by their ends: of curves down the page at one height, of curves across it at one
/// place, each group in the order of its ends.
fn together(mut ends: Vec<Named<'_>>, down: bool) -> Vec<Vec<Named<'_>>> {
    let turned = |(x, y): (f64, f64)| if down { (y, x) } else { (x, y) };
    ends.sort_by(|a, b| turned(a.at).0.total_cmp(&turned(b.at).0));
    let mut groups: Vec<Vec<Named>> = Vec::new();
    for name in ends {
        let first = groups.last().and_then(|group| group.first());
        let near = first.is_some_and(|first| turned(name.at).0 - turned(first.at).0 <= TOGETHER);
        match groups.last_mut().filter(|_| near) {
            Some(group) => group.push(name),
            None => groups.push(vec![name]),
        }
    }
    for group in &mut groups {
        group.sort_by(|a, b| turned(a.at).1.total_cmp(&turned(b.at).1));
    }
    groups
}

/// Boxes of the names of curves that end together: a row below the ends of curves down the page, a
/// column next to those of curves across it. `None` where they do not fit, or cover others.
fn at_ends(group: &[Named], all: &[Mark], place: &Place, taken: &[Box]) -> Option<Vec<Box>> {
    let frame = place.frame;
    let margin = place.margin.unwrap_or(0.0);
    let rooms = if place.down {
        let lowest = group.iter().map(|name| name.at.1).fold(f64::NEG_INFINITY, f64::max);
        let top = (lowest + GAP).min(frame.bottom() - HEIGHT - 1.0);
        let preferred = group.iter().map(|name| (name.at.0, name.width() + GAP));
        let lefts = spread(preferred, frame.left + 1.0, frame.right() - 1.0)?;
        let room = |(name, left): (&Named, f64)| Box {
            left: left + 0.5 * GAP,
            top,
            width: name.width(),
            height: HEIGHT,
        };
        vec![group.iter().zip(lefts).map(room).collect::<Vec<Box>>()]
    } else {
        let preferred = group.iter().map(|name| (name.at.1, HEIGHT));
        let tops = spread(preferred, frame.top + 1.0, frame.bottom() - 1.0)?;
        let column = |right: bool| {
            let room = |(name, top): (&Named, &f64)| {
                let width = name.width();
                let left = match right {
                    // Where names have a margin, all are there, clear of curves.
                    true if margin > 0.0 && name.at.0 + GAP + width > frame.right() => {
                        frame.right() + MARGIN_GAP
                    }
                    true => name.at.0 + GAP,
                    false => name.at.0 - GAP - width,
                };
                Box { left, top: *top, width, height: HEIGHT }
            };
            group.iter().zip(&tops).map(room).collect::<Vec<Box>>()
        };
        vec![column(true), column(false)]
    };
    let allowed = Box { width: frame.width + margin, ..frame };
    let fits = |rooms: &Vec<Box>| {
        rooms.iter().all(|room| {
            is_within(room, &allowed) && !taken.iter().any(|other| overlap(other, room))
        })
    };
    let crowd_of =
        |rooms: &Vec<Box>| rooms.iter().map(|room| crowd(room, all, place)).sum::<usize>();
    // The first of equal boxes.
    rooms.into_iter().filter(fits).min_by_key(crowd_of)
}

/// Beginnings of stretches with these middles and lengths so that none covers another, each as near
/// to its middle as the others allow and all in their order; `None` where they are longer together
/// than the line.
fn spread(preferred: impl Iterator<Item = (f64, f64)>, from: f64, to: f64) -> Option<Vec<f64>> {
    /// Stretches that touch: the beginning of the first, their lengths, and the sum of the
    /// beginnings of the first that each prefers.
    struct Block {
        begins: f64,
        lengths: Vec<f64>,
        length: f64,
        sum: f64,
    }
    let mut blocks: Vec<Block> = Vec::new();
    for (middle, length) in preferred {
        let mut block =
            Block { begins: 0.0, lengths: vec![length], length, sum: middle - 0.5 * length };
        loop {
            if block.length > to - from {
                return None;
            }
            let begins = block.sum / block.lengths.len() as f64;
            block.begins = begins.clamp(from, to - block.length);
            let Some(last) = blocks.pop_if(|last| last.begins + last.length > block.begins) else {
                break;
            };
            // The preferences of later ones are reduced by the length of those before them.
            let later = block.lengths.len() as f64;
            block.sum += last.sum - later * last.length;
            block.lengths.splice(0..0, last.lengths);
            block.length += last.length;
        }
        blocks.push(block);
    }
    let mut begins = Vec::new();
    for block in blocks {
        let mut at = block.begins;
        for length in block.lengths {
            begins.push(at);
            at += length;
        }
    }
    Some(begins)
}

/// A box next to a point, nearer to it than to any other that has a name, where few curves run.
fn beside(
    name: &Named,
    others: &[Named],
    all: &[Mark],
    place: &Place,
    taken: &[Box],
) -> Option<Box> {
    /// One more curve under a name costs as much as this many points of distance.
    const CURVE: f64 = 12.0;
    /// Cost of a name that is nearer to another point, because it may be taken for that one's.
    const FOREIGN: f64 = 1000.0;
    let width = name.width();
    let offsets =
        (0..8).flat_map(|step| [-1.0, 1.0].map(|side| side * (6.5 + 4.0 * f64::from(step))));
    let lefts = [name.at.0 - width - GAP, name.at.0 + GAP, name.at.0 - 0.5 * width];
    let rooms = offsets.flat_map(|off| {
        lefts.map(|left| Box { left, top: name.at.1 + off - 0.5 * HEIGHT, width, height: HEIGHT })
    });
    let free = rooms.filter(|room| {
        is_within(room, &place.frame) && !taken.iter().any(|other| overlap(other, room))
    });
    let cost = |room: &Box| {
        let own = distance(room, name.at);
        let is_foreign = others.iter().any(|other| distance(room, other.at) < own);
        let curves = crowd(room, all, place) as f64;
        own + CURVE * curves + if is_foreign { FOREIGN } else { 0.0 }
    };
    // The first of equal boxes.
    free.map(|room| (cost(&room), room)).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, room)| room)
}

/// Draws a name in its box, and a line to its point where that is far or another's is near.
fn draw(on: &mut Drawing, name: &Named, room: Box, all: &[Mark], place: &Place) {
    on.begin(name.keys, false);
    let nearest =
        (name.at.0.clamp(room.left, room.right()), name.at.1.clamp(room.top, room.bottom()));
    // From its middle, so that lines of neighbouring names do not meet.
    let middle = (room.left + 0.5 * room.width, room.top + 0.5 * HEIGHT);
    let start = match (name.ends, place.down) {
        (true, true) => (middle.0, nearest.1),
        (true, false) => (nearest.0, middle.1),
        (false, _) => nearest,
    };
    let off = (start.0 - name.at.0).hypot(start.1 - name.at.1);
    if off > FAR {
        let ink = ink_at(name.at, all, place);
        on.line(&[start, name.at], Pen::new(ink, 0.5));
    }
    on.fill(room.corners().to_vec(), Ink::Paper, 0.7);
    on.text(name.text, (room.left + 1.0, middle.1), SIZE, Ink::Text, Anchor::Start);
    on.end();
}

/// The colour of the curve that ends at a point; that of notes where none does.
fn ink_at(at: (f64, f64), all: &[Mark], place: &Place) -> Ink {
    let ends_there = |points: &[(f64, f64)]| {
        let finite = |point: &&(f64, f64)| (point.0 + point.1).is_finite();
        points.iter().rev().find(finite).is_some_and(|end| place.of(*end) == at)
    };
    let ink = all.iter().find_map(|mark| match mark {
        Mark::Curve { ink, points, .. } if ends_there(points) => Some(*ink),
        _ => None,
    });
    ink.unwrap_or(Ink::Note)
}

/// Distance of a point from a box, points.
fn distance(room: &Box, at: (f64, f64)) -> f64 {
    let x = at.0 - at.0.clamp(room.left, room.right());
    let y = at.1 - at.1.clamp(room.top, room.bottom());
    x.hypot(y)
}

fn is_within(room: &Box, frame: &Box) -> bool {
    room.left >= frame.left
        && room.right() <= frame.right()
        && room.top >= frame.top
        && room.bottom() <= frame.bottom()
}

fn overlap(a: &Box, b: &Box) -> bool {
    a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom()
}

/// Number of curves that run through a box.
pub(super) fn crowd(room: &Box, all: &[Mark], place: &Place) -> usize {
    let runs_through = |pair: &[(f64, f64)]| passes(room, place.of(pair[0]), place.of(pair[1]));
    let runs = |mark: &&Mark| match mark {
        Mark::Curve { points, .. } => points.windows(2).any(runs_through),
        _ => false,
    };
    all.iter().filter(runs).count()
}

/// Whether a straight line has a point in a box: the part of it that is within the box's width and
/// height at once (Liang and Barsky). A line to a point that is not finite passes nothing.
fn passes(room: &Box, a: (f64, f64), b: (f64, f64)) -> bool {
    if !(a.0 + a.1 + b.0 + b.1).is_finite() {
        return false;
    }
    let sides = [(a.0, b.0, room.left, room.right()), (a.1, b.1, room.top, room.bottom())];
    let mut part = (0.0_f64, 1.0_f64);
    for (from, to, low, high) in sides {
        if from == to {
            if !(low..=high).contains(&from) {
                return false;
            }
            continue;
        }
        let [one, other] = [low, high].map(|edge| (edge - from) / (to - from));
        part = (part.0.max(one.min(other)), part.1.min(one.max(other)));
    }
    part.0 <= part.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_keep_their_order_and_do_not_cover_each_other() {
        // Two that are far apart stay at their preferred places.
        assert_eq!(
            spread([(10.0, 4.0), (50.0, 4.0)].into_iter(), 0.0, 100.0).unwrap(),
            [8.0, 48.0]
        );
        // Three at 10, 11 and 12 of a length of 6 each have their middle at 11 together.
        let close = [(10.0, 6.0), (11.0, 6.0), (12.0, 6.0)];
        assert_eq!(spread(close.into_iter(), 0.0, 100.0).unwrap(), [2.0, 8.0, 14.0]);
        // At the edge of the line they stay on it.
        assert_eq!(spread(close.into_iter(), 5.0, 23.0).unwrap(), [5.0, 11.0, 17.0]);
        assert_eq!(spread(close.into_iter(), 0.0, 17.0), None);
    }

    #[test]
    fn a_line_passes_a_box_wherever_it_comes_from() {
        let room = Box { left: 10.0, top: 10.0, width: 4.0, height: 2.0 };
        assert!(passes(&room, (0.0, 11.0), (1e6, 11.0)));
        assert!(passes(&room, (12.0, -1e6), (12.0, 1e6)));
        assert!(passes(&room, (11.0, 11.0), (11.0, 11.0)));
        assert!(!passes(&room, (0.0, 13.0), (20.0, 13.0)));
        assert!(!passes(&room, (0.0, 0.0), (9.0, 20.0)));
        assert!(!passes(&room, (0.0, 11.0), (f64::NAN, 11.0)));
    }
}
