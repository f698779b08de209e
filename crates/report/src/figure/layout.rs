//! Layout of a figure on its page.

use super::{
    Direction, Figure, Mark,
    legend::Legend,
    names, panel,
    place::{self, LABEL, Place, TICK, shared_values, widest},
    ruler::Ruler,
};
use crate::draw::{Anchor, Box, Drawing, Ink, fitting, text_width};

/// Points of a millimetre.
const MILLIMETRE: f64 = 72.0 / 25.4;

const MARGIN: f64 = 5.0;
const TITLE: f64 = 9.5;
const SUBTITLE: f64 = 7.5;

/// Space over a frame for the label and the ticks of its own axis, where the shared one points
/// down.
const HEAD: f64 = 32.0;
/// Space below it, for the names of the sides.
const FOOT: f64 = 13.0;
/// Between two adjacent frames in a line.
const GAP: f64 = 14.0;
/// Space next to the frames for the hole.
const HOLE: f64 = 22.0;
/// Space next to a map for its colours.
const COLOURS: f64 = 56.0;
/// Space below a frame for the ticks of a shared axis across the page, and for its label.
const ACROSS: f64 = 25.0;
/// Between two frames one below the other.
const BELOW: f64 = 9.0;

impl Figure {
    /// The figure as it is drawn.
    pub fn drawing(&self) -> Drawing {
        draw(self)
    }
}

fn draw(figure: &Figure) -> Drawing {
    let width = figure.layout.width_mm * MILLIMETRE;
    let room = width - 2.0 * MARGIN;
    let legend = Legend::of_figure(&figure.keys, room);
    let title = if figure.title.is_empty() { 0.0 } else { 13.0 };
    let subtitle_lines = wrapped(&figure.subtitle, room);
    let subtitle = 10.5 * subtitle_lines.len() as f64;
    let under = if figure.keys.is_empty() { 0.0 } else { 6.0 };
    let top = MARGIN + title + subtitle + legend.height() + under;

    let marks = figure.panels.iter().flat_map(|panel| &panel.marks);
    let hole = figure.hole.iter().flat_map(|part| [part.from, part.to]);
    let values: Vec<f64> = marks.flat_map(shared_values).chain(hole).collect();
    let scaled;
    let figure = if figure.layout.direction == Direction::Plan {
        scaled = place::to_scale(figure, &values);
        &scaled
    } else {
        figure
    };
    let grid = Grid::of(figure, width, top, &values);

    let mut on = Drawing::new(&figure.title, width, grid.bottom + MARGIN);
    let y = MARGIN + 0.5 * TITLE;
    let text = fitting(&figure.title, TITLE, room);
    on.text(&text, (MARGIN, y), TITLE, Ink::Text, Anchor::Start);
    for (line, text) in subtitle_lines.iter().enumerate() {
        let y = MARGIN + title + 0.5 * SUBTITLE + 10.5 * line as f64;
        on.text(text, (MARGIN, y), SUBTITLE, Ink::Note, Anchor::Start);
    }
    legend.draw(&mut on, MARGIN, MARGIN + title + subtitle);
    grid.draw(&mut on, figure);
    on
}

/// A text in lines, broken at semicolons, and between words where a part is longer than a line.
fn wrapped(text: &str, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut add = |part: &str, joint: &str, begins: bool| match lines.last_mut() {
        Some(line) if !begins && fits(&format!("{line}{joint}{part}"), room) => {
            line.push_str(joint);
            line.push_str(part);
        }
        _ => lines.push(fitting(part, SUBTITLE, room)),
    };
    for part in text.split("; ").filter(|part| !part.is_empty()) {
        if fits(part, room) {
            add(part, "; ", false);
            continue;
        }
        for (place, word) in part.split(' ').enumerate() {
            add(word, " ", place == 0);
        }
    }
    lines
}

/// Whether a subtitle is no longer than a line.
fn fits(text: &str, room: f64) -> bool {
    text_width(text, SUBTITLE) <= room
}

/// Width next to a frame for the names of curves that end at its right, so that no curve runs through
/// them; zero where there are none. `None` where they would take too much of this width and the
/// legend has them too, so that they are left out.
fn margin(figure: &Figure, room: f64) -> Option<f64> {
    const MOST: f64 = 0.3;
    if figure.layout.direction != Direction::Across {
        return Some(0.0);
    }
    let marks = figure.panels.iter().flat_map(|panel| &panel.marks);
    let widths = marks.filter_map(|mark| match mark {
        Mark::Foot { text, .. } => Some(names::margin(text)),
        _ => None,
    });
    let widest = widths.fold(0.0, f64::max);
    match widest <= MOST * room {
        true => Some(widest),
        false => figure.keys.is_empty().then_some(0.0),
    }
}

/// The frames of the panels.
struct Grid {
    frames: Vec<Box>,
    shared: Ruler,
    bottom: f64,
    /// Width next to each frame for names, points; `None` where they are left out.
    margin: Option<f64>,
}

impl Grid {
    fn of(figure: &Figure, width: f64, top: f64, values: &[f64]) -> Self {
        match figure.layout.direction {
            Direction::Down => Self::down(figure, width, top, values),
            Direction::Across | Direction::Plan => Self::across(figure, width, top, values),
        }
    }

    fn down(figure: &Figure, width: f64, top: f64, values: &[f64]) -> Self {
        let height = figure.layout.panel_mm * MILLIMETRE;
        let shared = Ruler::new(&figure.shared, values.iter().copied(), height / 24.0);
        let columns = figure.layout.columns.clamp(1, figure.panels.len().max(1));
        let left = MARGIN + LABEL + 4.0 + widest(&shared) + 4.0;
        let right = if figure.hole.is_empty() { MARGIN + 3.0 } else { MARGIN + HOLE };
        let wide = (width - left - right - GAP * (columns - 1) as f64) / columns as f64;
        let line = HEAD + height + FOOT;
        let frames = (0..figure.panels.len()).map(|index| Box {
            left: left + (index % columns) as f64 * (wide + GAP),
            top: top + (index / columns) as f64 * line + HEAD,
            width: wide,
            height,
        });
        let frames: Vec<Box> = frames.collect();
        let bottom = frames.last().map_or(top, |last| last.bottom() + FOOT);
        Self { frames, shared, bottom, margin: Some(0.0) }
    }

    fn across(figure: &Figure, width: f64, top: f64, values: &[f64]) -> Self {
        let height = figure.layout.panel_mm * MILLIMETRE;
        let columns = figure.layout.columns.clamp(1, figure.panels.len().max(1));
        // The number of ticks depends on the width of the frame, and that on the ticks.
        let about = Ruler::new(&figure.shared, values.iter().copied(), 8.0);
        let probe = Box { left: 0.0, top: 0.0, width: 100.0, height };
        let panels = || figure.panels.iter();
        let left = panels()
            .map(|panel| Place::new(figure, panel, &about, probe).beside(&panel.axis.label))
            .fold(0.0, f64::max);
        let has_map =
            panels().flat_map(|panel| &panel.marks).any(|mark| matches!(mark, Mark::Map(_)));
        let room = (width - 2.0 * MARGIN) / columns as f64;
        let names = margin(figure, room);
        let right = if has_map { COLOURS } else { names.unwrap_or(0.0).max(7.0) };
        let wide = room - left - right;
        let (wide, height) = match figure.layout.direction {
            Direction::Plan => place::frame(figure, (wide, height)),
            Direction::Down | Direction::Across => (wide, height),
        };
        let count = (wide / (widest(&about) + 14.0)).clamp(2.0, 12.0);
        let shared = Ruler::new(&figure.shared, values.iter().copied(), count);
        let mut y = top;
        let mut frames = Vec::new();
        for (index, line) in figure.panels.chunks(columns).enumerate() {
            let keys = line
                .iter()
                .map(|panel| match &panel.keys[..] {
                    [] => 0.0,
                    keys => Legend::of(keys, wide).height() + 2.0,
                })
                .fold(0.0, f64::max);
            let is_last = (index + 1) * columns >= figure.panels.len();
            y += keys + 4.0;
            frames.extend((0..line.len()).map(|column| Box {
                left: MARGIN + column as f64 * (left + wide + right) + left,
                top: y,
                width: wide,
                height,
            }));
            y += height + if is_last || columns > 1 { ACROSS } else { BELOW };
        }
        Self { frames, shared, bottom: y, margin: names }
    }

    fn draw(&self, on: &mut Drawing, figure: &Figure) {
        let columns = figure.layout.columns.max(1);
        for (index, (panel, frame)) in figure.panels.iter().zip(&self.frames).enumerate() {
            let place = Place::new(figure, panel, &self.shared, *frame);
            let place = Place { margin: self.margin, ..place };
            panel::draw(on, figure, panel, &place);
            match figure.layout.direction {
                Direction::Down if index % columns == 0 => {
                    self.depths(on, figure, &place);
                }
                Direction::Down => {}
                Direction::Across | Direction::Plan => {
                    if !panel.keys.is_empty() {
                        let legend = Legend::of(&panel.keys, frame.width);
                        legend.draw(on, frame.left, frame.top - 2.0 - legend.height());
                    }
                    if index + columns >= figure.panels.len() || columns > 1 {
                        self.below(on, figure, &place);
                    }
                }
            }
            let is_last = (index + 1) % columns == 0 || index + 1 == figure.panels.len();
            if figure.layout.direction == Direction::Down && is_last {
                hole(on, figure, &place);
            }
        }
    }

    /// The shared axis to the left of a frame.
    fn depths(&self, on: &mut Drawing, figure: &Figure, place: &Place<'_>) {
        let frame = place.frame;
        for (value, text) in &self.shared.ticks {
            let y = place.shared_line(*value)[0].1;
            on.text(text, (frame.left - 4.0, y), TICK, Ink::Text, Anchor::End);
        }
        let x = MARGIN + 0.5 * LABEL;
        let y = frame.top + frame.height / 2.0;
        on.upright(&figure.shared.label, (x, y), LABEL, Ink::Text);
    }

    /// The shared axis below a frame.
    fn below(&self, on: &mut Drawing, figure: &Figure, place: &Place<'_>) {
        let frame = place.frame;
        for (value, text) in &self.shared.ticks {
            let half = 0.5 * text_width(text, TICK);
            let x = place.shared_line(*value)[0].0;
            let x = x.min(frame.right() + 6.0 - half);
            let at = (x, frame.bottom() + 7.0);
            on.text(text, at, TICK, Ink::Text, Anchor::Middle);
        }
        let at = (frame.left + frame.width / 2.0, frame.bottom() + 18.0);
        let label = &figure.shared.label;
        on.text(label, at, LABEL, Ink::Text, Anchor::Middle);
    }
}

/// A strip next to a frame with casing and rock, and a triangle at each casing shoe.
fn hole(on: &mut Drawing, figure: &Figure, place: &Place<'_>) {
    const SIZE: f64 = 6.5;
    let left = place.frame.right() + 6.0;
    let right = left + 5.0;
    for interval in &figure.hole {
        let [from, to] = [interval.from, interval.to].map(|md| place.shared_line(md)[0].1);
        let ink = if interval.cased { Ink::Casing } else { Ink::Rock };
        let strip = vec![(left, from), (right, from), (right, to), (left, to)];
        on.fill(strip, ink, 1.0);
        if interval.shoe {
            let shoe = vec![(left, to - 5.0), (left, to), (left - 3.5, to)];
            on.fill(shoe, Ink::Frame, 1.0);
        }
        if to - from > text_width(&interval.label, SIZE) + 4.0 {
            let middle = (right + 7.0, (from + to) / 2.0);
            on.upright(&interval.label, middle, SIZE, Ink::Note);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No word of a subtitle is cut off: a part that is longer than a line is broken between words,
    /// and the next part follows it.
    #[test]
    fn a_long_subtitle_is_broken_between_words() {
        let text = "soft string; limits beyond the picture: top drive 30 kN·m, peak 40 kN·m; mud";
        let lines = wrapped(text, 120.0);
        assert!(lines.len() > 2, "{lines:?}");
        assert!(lines.iter().all(|line| fits(line, 120.0) && !line.contains('…')), "{lines:?}");
        let words = |text: &str| text.replace(';', "").split_whitespace().count();
        assert_eq!(lines.iter().map(|line| words(line)).sum::<usize>(), words(text));
        assert_eq!(lines[0], "soft string");
    }
}
