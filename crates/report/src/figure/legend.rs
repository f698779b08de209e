//! Legends of colours, strokes and shapes.

use super::{
    Key, Sample, found,
    marks::{BAND, bar, pen, shape},
};
use crate::draw::{Anchor, Drawing, Ink, text_width};

/// A legend in aligned columns.
pub(super) struct Legend<'a> {
    keys: &'a [Key],
    width: f64,
    columns: usize,
    /// Whether it belongs to the whole figure, whose keys a page can hide.
    of_figure: bool,
}

const SIZE: f64 = 7.5;
const ROW: f64 = 11.5;
/// Length of a sample, and of the space up to its name.
const SAMPLE: f64 = 17.0;
const NAME: f64 = 21.0;
/// Between two entries.
const APART: f64 = 12.0;
/// Factor on the widths of names, which are measured as in Helvetica: a reader without that, or one
/// of its width, has names up to this many times as wide (DejaVu Sans).
const LOOSE: f64 = 1.12;

impl<'a> Legend<'a> {
    pub(super) fn of(keys: &'a [Key], room: f64) -> Self {
        let names = keys.iter().map(|key| text_width(&key.name, SIZE));
        let width = NAME + LOOSE * names.fold(0.0, f64::max);
        Self {
            keys,
            width: width + APART,
            columns: (((room + APART) / (width + APART)).floor() as usize)
                .clamp(1, keys.len().max(1)),
            of_figure: false,
        }
    }

    /// The same, for the whole figure.
    pub(super) fn of_figure(keys: &'a [Key], room: f64) -> Self {
        Self { of_figure: true, ..Self::of(keys, room) }
    }

    pub(super) fn height(&self) -> f64 {
        ROW * self.keys.len().div_ceil(self.columns) as f64
    }

    /// Draws it with its upper left corner at this place.
    pub(super) fn draw(&self, on: &mut Drawing, left: f64, top: f64) {
        for (index, key) in self.keys.iter().enumerate() {
            on.begin(&[index], self.of_figure);
            let x = left + self.width * (index % self.columns) as f64;
            let y = top + ROW * (0.5 + (index / self.columns) as f64);
            let across = [(x, y), (x + SAMPLE, y)];
            let block = |half: f64| {
                vec![(x, y - half), (x + SAMPLE, y - half), (x + SAMPLE, y + half), (x, y + half)]
            };
            match key.sample {
                Sample::Line(ink, stroke) => on.line(&across, pen(ink, stroke)),
                Sample::Band(ink) => on.fill(block(3.0), ink, BAND),
                Sample::Area(ink) => on.fill(block(3.0), ink, 1.0),
                Sample::Point(ink, form) => shape(on, form, (x + SAMPLE / 2.0, y), ink),
                Sample::Marked(ink, stroke, form) => {
                    on.line(&across, pen(ink, stroke));
                    shape(on, form, (x + SAMPLE / 2.0, y), ink);
                }
                Sample::Spread(ink) => bar(on, across[0], across[1], ink),
                Sample::Found(level) => found::sample(on, level, (x, y - 3.0), (SAMPLE, 6.0)),
                Sample::Ring(level) => found::ring(on, level, (x + SAMPLE / 2.0, y)),
                Sample::Words => {}
            }
            let before = match key.sample {
                Sample::Words => 0.0,
                _ => NAME,
            };
            let at = (x + before, y);
            on.text(&key.name, at, SIZE, Ink::Text, Anchor::Start);
            on.end();
        }
    }
}
