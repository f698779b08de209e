//! The legend under the title.

use plotters::style::text_anchor::HPos;

use crate::{
    canvas::{Canvas, Drawn, LETTER},
    colours,
    profile::Entry,
};

/// The legend in aligned columns under the title.
pub(crate) struct Legend<'a> {
    entries: &'a [Entry],
    width: f64,
    columns: usize,
}

const SIZE: f64 = 12.5;
const ROW: f64 = 20.0;
/// Length of a sample of the line, and of the space up to its name.
const SAMPLE: f64 = 28.0;
const ENTRY: f64 = 36.0;

impl<'a> Legend<'a> {
    pub(crate) fn of(entries: &'a [Entry], room: f64) -> Self {
        let letters = entries.iter().map(|entry| entry.name.chars().count()).max();
        let width = ENTRY + LETTER * SIZE * letters.unwrap_or(0) as f64 + 14.0;
        Self {
            entries,
            width,
            columns: (room / width).floor().max(1.0) as usize,
        }
    }

    pub(crate) fn height(&self) -> f64 {
        ROW * self.entries.len().div_ceil(self.columns) as f64
    }

    pub(crate) fn draw(&self, canvas: &Canvas, left: f64, top: f64) -> Drawn {
        for (index, entry) in self.entries.iter().enumerate() {
            let x = left + self.width * (index % self.columns) as f64;
            let y = top + ROW * (index / self.columns) as f64;
            let colour = entry.colour.map_or(colours::NOTE, colours::line);
            canvas.curve(&[(x, y), (x + SAMPLE, y)], colour, entry.stroke)?;
            let x = x + ENTRY;
            canvas.text(&entry.name, x, y, SIZE, colours::TEXT, HPos::Left)?;
        }
        Ok(())
    }
}
