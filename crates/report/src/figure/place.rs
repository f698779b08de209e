//! Places of values in a panel's frame.

use super::{Axis, Direction, Figure, Mark, Panel, Range, outliers, ruler::Ruler};
use crate::draw::{Box, text_width};

pub(super) const TICK: f64 = 7.0;
pub(super) const LABEL: f64 = 8.0;

/// Nothing is drawn farther from the page than this, points, because a dashed line to an extreme
/// value would have no end.
const FAR: f64 = 1e6;

/// Places of values in a frame.
pub(super) struct Place<'a> {
    pub(super) frame: Box,
    /// Whether the shared axis points down the page.
    pub(super) down: bool,
    pub(super) shared: &'a Ruler,
    pub(super) own: Ruler,
    /// Whether the panel's own axis does.
    pub(super) own_down: bool,
    /// Width to the right of the frame for the names of curves that end there, points; `None`
    /// where these are left out.
    pub(super) margin: Option<f64>,
}

impl<'a> Place<'a> {
    pub(super) fn new(figure: &Figure, panel: &Panel, shared: &'a Ruler, frame: Box) -> Self {
        let down = figure.layout.direction == Direction::Down;
        let values = reached(panel);
        let values = || values.iter().copied();
        let own = if down {
            unhurried(&panel.axis, &values, &frame)
        } else {
            Ruler::new(&panel.axis, values(), frame.height / 20.0)
        };
        Self { frame, down, shared, own, own_down: panel.axis.down, margin: Some(0.0) }
    }

    /// The place on the page of a shared value and one of the panel's own.
    pub(super) fn of(&self, (shared, own): (f64, f64)) -> (f64, f64) {
        if self.down {
            (self.across(self.own.place(own)), self.below(self.shared.place(shared)))
        } else {
            (self.across(self.shared.place(shared)), self.own_y(own))
        }
    }

    pub(super) fn across(&self, part: f64) -> f64 {
        (self.frame.left + self.frame.width * part).clamp(-FAR, FAR)
    }

    pub(super) fn below(&self, part: f64) -> f64 {
        (self.frame.top + self.frame.height * part).clamp(-FAR, FAR)
    }

    pub(super) fn own_y(&self, own: f64) -> f64 {
        let part = self.own.place(own);
        self.below(if self.own_down { part } else { 1.0 - part })
    }

    /// The line across the frame at a value of the shared axis.
    pub(super) fn shared_line(&self, at: f64) -> [(f64, f64); 2] {
        let place = self.shared.place(at);
        if self.down { self.level(self.below(place)) } else { self.upright(self.across(place)) }
    }

    /// The line along the frame at one of the panel's own values.
    pub(super) fn own_line(&self, at: f64) -> [(f64, f64); 2] {
        if self.down {
            self.upright(self.across(self.own.place(at)))
        } else {
            self.level(self.own_y(at))
        }
    }

    fn level(&self, y: f64) -> [(f64, f64); 2] {
        [(self.frame.left, y), (self.frame.right(), y)]
    }

    fn upright(&self, x: f64) -> [(f64, f64); 2] {
        [(x, self.frame.top), (x, self.frame.bottom())]
    }

    /// The shared value at a part of the frame's width; for an axis that points across.
    pub(super) fn shared_at(&self, part: f64) -> f64 {
        self.shared.value(part)
    }

    /// The panel's own value at a part of the frame's height from the top; for an axis that points
    /// up or down.
    pub(super) fn own_at(&self, part: f64) -> f64 {
        self.own.value(if self.own_down { part } else { 1.0 - part })
    }

    /// The widest text at the panel's own axis.
    pub(super) fn widest(&self) -> f64 {
        widest(&self.own)
    }

    /// Width of ticks and label of its own axis to the left of the frame.
    pub(super) fn beside(&self, label: &str) -> f64 {
        let lines = if text_width(label, LABEL) <= self.frame.height { 1.0 } else { 2.0 };
        4.0 + self.widest() + 4.0 + 9.5 * lines
    }
}

pub(super) fn widest(ruler: &Ruler) -> f64 {
    let widths = ruler.ticks.iter().map(|(_, text)| text_width(text, TICK));
    widths.fold(0.0, f64::max)
}

/// The ruler with as many ticks as fit in a line over the frame.
fn unhurried<I: Iterator<Item = f64>>(axis: &Axis, values: &dyn Fn() -> I, frame: &Box) -> Ruler {
    let most = (frame.width / 24.0).floor().max(2.0) as usize;
    let rulers = (1..=most).rev().map(|count| Ruler::new(axis, values(), count as f64));
    let mut last = None;
    for ruler in rulers {
        let places: Vec<(f64, f64)> = ruler
            .ticks
            .iter()
            .map(|(value, text)| {
                let half = 0.5 * text_width(text, TICK);
                let middle = inside(frame.left + frame.width * ruler.place(*value), half, frame);
                (middle - half, middle + half)
            })
            .collect();
        let apart = places.windows(2).all(|pair| pair[0].1 + 4.0 <= pair[1].0);
        if apart && !places.is_empty() {
            return ruler;
        }
        last = Some(ruler);
    }
    last.expect("one ruler at least")
}

/// The middle of a text so that it does not reach far beyond the frame.
pub(super) fn inside(middle: f64, half: f64, frame: &Box) -> f64 {
    const BEYOND: f64 = 3.0;
    let (low, high) = (frame.left + half - BEYOND, frame.right() - half + BEYOND);
    middle.clamp(low.min(high), high.max(low))
}

/// The values on a panel's own axis that it has to reach: those of all marks except outliers, where
/// it leaves them out.
pub(super) fn reached(panel: &Panel) -> Vec<f64> {
    let values: Vec<f64> = panel.marks.iter().flat_map(own_values).collect();
    if !panel.axis.clips {
        return values;
    }
    let rules = panel.marks.iter().filter_map(|mark| match mark {
        Mark::OwnRule { at, .. } => Some(*at),
        _ => None,
    });
    let ends = outliers::without(&values, panel.axis.range == Range::Zero);
    let ends = ends.into_iter().flat_map(|(low, high)| [low, high]);
    ends.chain(rules).collect()
}

/// The values on a panel's own axis.
fn own_values(mark: &Mark) -> Vec<f64> {
    match mark {
        Mark::Curve { points, .. } | Mark::Sides { points } | Mark::Points { points, .. } => {
            points.iter().map(|point| point.1).collect()
        }
        Mark::Band { points, .. } => points.iter().flat_map(|point| [point.1, point.2]).collect(),
        Mark::Bars { bars, .. } => bars.iter().flatten().map(|end| end.1).collect(),
        Mark::OwnRule { at, .. } => vec![*at],
        Mark::SharedRule { .. }
        | Mark::Shade { .. }
        | Mark::Found { .. }
        | Mark::Rings { .. }
        | Mark::Of { .. }
        | Mark::Name { .. }
        | Mark::Foot { .. }
        | Mark::Spots { .. } => Vec::new(),
        Mark::Map(map) => map.middles.clone(),
    }
}

/// The values on the shared axis that it has to reach.
pub(super) fn shared_values(mark: &Mark) -> Vec<f64> {
    match mark {
        Mark::Curve { points, .. } | Mark::Sides { points } | Mark::Points { points, .. } => {
            points.iter().map(|point| point.0).collect()
        }
        Mark::Band { points, .. } => points.iter().map(|point| point.0).collect(),
        Mark::Bars { bars, .. } => bars.iter().flatten().map(|end| end.0).collect(),
        Mark::Map(map) => map.ends.iter().copied().chain([map.from]).collect(),
        Mark::SharedRule { .. }
        | Mark::OwnRule { .. }
        | Mark::Shade { .. }
        | Mark::Found { .. }
        | Mark::Rings { .. }
        | Mark::Of { .. }
        | Mark::Name { .. }
        | Mark::Foot { .. }
        | Mark::Spots { .. } => Vec::new(),
    }
}

// Two axes to the same scale.

/// The longer axis is at most this many times as long as the other, because a vertical well seen
/// from the side is a line.
const LONGEST: f64 = 4.0;

/// The figure with fixed ends of both axes, the same for all of its panels, neither much shorter
/// than the other.
pub(super) fn to_scale(figure: &Figure, shared: &[f64]) -> Figure {
    let mut scaled = figure.clone();
    let across = Ruler::new(&figure.shared, shared.iter().copied(), 1.0).ends();
    let up = figure
        .panels
        .iter()
        .map(|panel| Ruler::new(&panel.axis, reached(panel), 1.0).ends())
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
        .unwrap_or((0.0, 1.0));
    fix(&mut scaled.shared, across, up);
    for panel in &mut scaled.panels {
        fix(&mut panel.axis, up, across);
    }
    scaled
}

/// Sets the ends of an axis, or as much as it needs relative to the other.
fn fix(axis: &mut Axis, (from, to): (f64, f64), other: (f64, f64)) {
    let missing = ((other.1 - other.0) / LONGEST - (to - from)).max(0.0);
    axis.range = Range::Fixed(from - 0.5 * missing, to + 0.5 * missing);
}

/// Width and height of a frame within this space that has both axes of a scaled figure to the same
/// scale.
pub(super) fn frame(figure: &Figure, (wide, high): (f64, f64)) -> (f64, f64) {
    let span = |axis: &Axis| match axis.range {
        Range::Fixed(from, to) if to > from => to - from,
        _ => 1.0,
    };
    let across = span(&figure.shared);
    let up = figure.panels.first().map_or(across, |panel| span(&panel.axis));
    let scale = (wide / across).min(high / up);
    (across * scale, up * scale)
}
