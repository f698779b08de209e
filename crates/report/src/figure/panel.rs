//! A panel: its frame, its ticks and what is in it.

use super::{
    Axis, Direction, Figure, Map, Mark, Panel, Range, Scale, beyond, marks, outliers, ruler::Ruler,
};
use crate::draw::{Anchor, Box, ColourScale, Drawing, Hue, Ink, Pen, fitting, text_width};

pub(super) const TICK: f64 = 7.0;
pub(super) const LABEL: f64 = 8.0;
/// What stands below a frame to say which side is which.
const SIDE: f64 = 6.5;

const FRAME: f64 = 0.6;
const GRID: f64 = 0.4;

/// Where values lie in a frame.
pub(super) struct Place<'a> {
    pub(super) frame: Box,
    /// Whether the shared axis points down the page.
    pub(super) down: bool,
    pub(super) shared: &'a Ruler,
    pub(super) own: Ruler,
    /// Whether the panel's own axis does.
    pub(super) own_down: bool,
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
        Self {
            frame,
            down,
            shared,
            own,
            own_down: panel.axis.down,
        }
    }

    /// The place on the page of a shared value and one of the panel's own.
    pub(super) fn of(&self, (shared, own): (f64, f64)) -> (f64, f64) {
        if self.down {
            (
                self.across(self.own.place(own)),
                self.below(self.shared.place(shared)),
            )
        } else {
            (self.across(self.shared.place(shared)), self.own_y(own))
        }
    }

    fn across(&self, part: f64) -> f64 {
        self.frame.left + self.frame.width * part
    }

    fn below(&self, part: f64) -> f64 {
        self.frame.top + self.frame.height * part
    }

    fn own_y(&self, own: f64) -> f64 {
        let part = self.own.place(own);
        self.below(if self.own_down { part } else { 1.0 - part })
    }

    /// The line across the frame at a value of the shared axis.
    pub(super) fn shared_line(&self, at: f64) -> [(f64, f64); 2] {
        let place = self.shared.place(at);
        if self.down {
            self.level(self.below(place))
        } else {
            self.upright(self.across(place))
        }
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

    /// The shared value at a part of the frame's width; of an axis that points across.
    pub(super) fn shared_at(&self, part: f64) -> f64 {
        self.shared.value(part)
    }

    /// The panel's own value at a part of the frame's height from the top; of an axis that points up or down.
    pub(super) fn own_at(&self, part: f64) -> f64 {
        self.own
            .value(if self.own_down { part } else { 1.0 - part })
    }

    /// The widest text at the panel's own axis.
    fn widest(&self) -> f64 {
        widest(&self.own)
    }

    /// The room that ticks and label of its own axis take to the left of the frame.
    pub(super) fn beside(&self, label: &str) -> f64 {
        let lines = if text_width(label, LABEL) <= self.frame.height {
            1.0
        } else {
            2.0
        };
        4.0 + self.widest() + 4.0 + 9.5 * lines
    }
}

pub(super) fn widest(ruler: &Ruler) -> f64 {
    let widths = ruler.ticks.iter().map(|(_, text)| text_width(text, TICK));
    widths.fold(0.0, f64::max)
}

/// The ruler with as many ticks as stand side by side over the frame.
fn unhurried<I: Iterator<Item = f64>>(axis: &Axis, values: &dyn Fn() -> I, frame: &Box) -> Ruler {
    let most = (frame.width / 24.0).floor().max(2.0) as usize;
    let rulers = (1..=most)
        .rev()
        .map(|count| Ruler::new(axis, values(), count as f64));
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
fn inside(middle: f64, half: f64, frame: &Box) -> f64 {
    const BEYOND: f64 = 3.0;
    let (low, high) = (frame.left + half - BEYOND, frame.right() - half + BEYOND);
    middle.clamp(low.min(high), high.max(low))
}

/// The values on a panel's own axis that it has to reach: those of all marks but for outliers, where it leaves them out.
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
        | Mark::Spots { .. } => Vec::new(),
    }
}

/// Draws a panel with the ticks and the label of its own axis.
pub(super) fn draw(on: &mut Drawing, figure: &Figure, panel: &Panel, place: &Place<'_>) {
    let frame = place.frame;
    let shade = |mark: &&Mark| matches!(mark, Mark::Shade { .. } | Mark::Found { .. });
    on.within(frame, |on| {
        for mark in panel.marks.iter().filter(shade) {
            marks::draw(on, mark, &panel.marks, place);
        }
    });
    grid(on, figure, place);
    for interval in figure.hole.iter().filter(|interval| interval.shoe) {
        let pen = Pen {
            dash: Some([1.0, 1.6]),
            ..Pen::new(Ink::Note, 0.6)
        };
        let line = place.shared_line(interval.to);
        if (frame.top + 1.0..frame.bottom() - 1.0).contains(&line[0].1) {
            on.line(&line, pen);
        }
    }
    on.within(frame, |on| {
        let mut open = false;
        for mark in panel.marks.iter().filter(|mark| !shade(mark)) {
            if let Mark::Of { keys } = mark {
                if open {
                    on.end();
                }
                on.begin(keys, false);
                open = true;
            }
            marks::draw(on, mark, &panel.marks, place);
        }
        if open {
            on.end();
        }
    });
    marks::names(on, &panel.marks, place);
    on.frame(frame, Pen::new(Ink::Frame, FRAME));
    if panel.axis.clips {
        beyond::draw(on, &panel.marks, place);
    }
    own_axis(on, panel, place);
    for mark in &panel.marks {
        if let Mark::Map(map) = mark {
            colour_bar(on, map, &frame);
        }
    }
}

fn grid(on: &mut Drawing, figure: &Figure, place: &Place<'_>) {
    let zero = Pen::new(Ink::Frame, GRID);
    let grid = Pen::new(Ink::Grid, GRID);
    if !matches!(figure.shared.scale, Scale::Words(_)) {
        for (value, _) in &place.shared.ticks {
            on.line(&place.shared_line(*value), grid);
        }
    }
    for (value, _) in &place.own.ticks {
        on.line(
            &place.own_line(*value),
            if *value == 0.0 { zero } else { grid },
        );
    }
}

/// Name and unit of a label, if it has both.
fn parts(label: &str) -> (&str, &str) {
    label.rsplit_once(", ").unwrap_or((label, ""))
}

fn own_axis(on: &mut Drawing, panel: &Panel, place: &Place<'_>) {
    let frame = place.frame;
    if place.down {
        for (value, text) in &place.own.ticks {
            let half = 0.5 * text_width(text, TICK);
            let x = inside(place.across(place.own.place(*value)), half, &frame);
            on.text(text, (x, frame.top - 6.0), TICK, Ink::Text, Anchor::Middle);
        }
        let middle = frame.left + frame.width / 2.0;
        let (name, unit) = parts(&panel.axis.label);
        on.text(
            name,
            (middle, frame.top - 25.0),
            LABEL,
            Ink::Text,
            Anchor::Middle,
        );
        on.text(
            unit,
            (middle, frame.top - 15.5),
            TICK,
            Ink::Note,
            Anchor::Middle,
        );
        if let Some([low, high]) = &panel.axis.sides {
            let y = frame.bottom() + 6.0;
            on.text(low, (frame.left, y), SIDE, Ink::Note, Anchor::Start);
            on.text(high, (frame.right(), y), SIDE, Ink::Note, Anchor::End);
        }
    } else {
        for (value, text) in &place.own.ticks {
            let y = place.own_y(*value);
            on.text(text, (frame.left - 4.0, y), TICK, Ink::Text, Anchor::End);
        }
        let x = frame.left - 4.0 - place.widest() - 8.0;
        let y = frame.top + frame.height / 2.0;
        let label = &panel.axis.label;
        if text_width(label, LABEL) <= frame.height {
            on.upright(label, (x, y), LABEL, Ink::Text);
        } else {
            // Name and unit one beside the other, each as long as fits.
            let (name, unit) = parts(label);
            let name = fitting(name, LABEL, frame.height + 8.0);
            on.upright(&name, (x - 9.5, y), LABEL, Ink::Text);
            on.upright(unit, (x, y), TICK, Ink::Note);
        }
    }
}

/// What the colours of a map tell, to the right of its frame.
fn colour_bar(on: &mut Drawing, map: &Map, frame: &Box) {
    let bar = Box {
        left: frame.right() + 8.0,
        width: 7.0,
        ..*frame
    };
    const STEPS: usize = 256;
    // Depth grows down the page.
    let at = |part: f64| match map.hue {
        Hue::Depth => part,
        Hue::Side | Hue::Amount => 1.0 - part,
    };
    let scale = ColourScale::new(map.hue);
    let pixels = (0..STEPS).map(|row| Some(scale.at(at((row as f64 + 0.5) / STEPS as f64))));
    let image = crate::draw::Image {
        columns: 1,
        pixels: pixels.collect(),
    };
    on.image(image, bar);
    on.frame(bar, Pen::new(Ink::Frame, FRAME));
    let from = match map.hue {
        Hue::Side => -map.largest,
        Hue::Amount | Hue::Depth => 0.0,
    };
    let axis = Axis::new("", super::Range::Fixed(from, map.largest));
    let ruler = Ruler::new(&axis, [], frame.height / 20.0);
    for (value, text) in &ruler.ticks {
        let y = bar.top + bar.height * at(ruler.place(*value));
        on.text(text, (bar.right() + 3.0, y), TICK, Ink::Text, Anchor::Start);
    }
    let x = bar.right() + 3.0 + widest(&ruler) + 7.0;
    let at = |part: f64| (x, bar.top + part * bar.height);
    match &map.sides {
        Some([low, high]) => {
            on.upright(&map.label, at(0.5), LABEL, Ink::Text);
            on.upright(high, at(0.14), SIDE, Ink::Note);
            on.upright(low, at(0.86), SIDE, Ink::Note);
        }
        None => on.upright(&map.label, at(0.5), LABEL, Ink::Text),
    }
}
