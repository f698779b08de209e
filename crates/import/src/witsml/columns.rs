//! The units of a survey's columns: measured depth, inclination, azimuth.

use std::collections::BTreeMap;

use super::measure::Measure;
use crate::fragment::Note;

/// Units of the stations and how often each occurs.
#[derive(Default)]
pub(crate) struct Units(BTreeMap<(usize, &'static str), usize>);

impl Units {
    /// Counts a number of a column.
    pub(crate) fn add(&mut self, column: usize, measure: &Measure) {
        *self.0.entry((column, measure.unit.symbol)).or_default() += 1;
    }

    /// Units of a column, the most common first.
    fn of(&self, index: usize) -> Vec<&'static str> {
        let mut found: Vec<(usize, &str)> = self
            .0
            .iter()
            .filter(|((column, _), _)| *column == index)
            .map(|((_, symbol), count)| (*count, *symbol))
            .collect();
        found.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        found.into_iter().map(|(_, symbol)| symbol).collect()
    }

    /// The most common unit of each column: `ft, deg, deg`.
    pub(crate) fn said(&self) -> String {
        let commonest = |index| self.of(index).first().copied().unwrap_or("deg");
        [0, 1, 2].map(commonest).join(", ")
    }

    /// Note if a column has several units, or angles are not in degrees.
    pub(crate) fn note(&self) -> Option<Note> {
        let columns = [0, 1, 2].map(|index| self.of(index).join(" and "));
        let plain = self.of(0).len() == 1
            && columns[1..].iter().all(|column| ["", "deg"].contains(&column.as_str()));
        let text = format!("md, incl and azi of the stations are in {}", columns.join(", "));
        (!plain).then_some(Note::Read(text))
    }
}
