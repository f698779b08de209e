//! The units of a survey's columns: measured depth, inclination, azimuth.

use std::collections::BTreeMap;

use super::measure::Measure;
use crate::fragment::Note;

/// The units that stations are written in, and how often each.
#[derive(Default)]
pub(crate) struct Units(BTreeMap<(usize, &'static str), usize>);

impl Units {
    /// Counts a number of a column.
    pub(crate) fn add(&mut self, column: usize, measure: &Measure) {
        *self.0.entry((column, measure.unit.symbol)).or_default() += 1;
    }

    /// Those of a column, the commonest first.
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

    /// `ft, deg, deg`: the commonest of each column.
    pub(crate) fn said(&self) -> String {
        let commonest = |index| self.of(index).first().copied().unwrap_or("deg");
        [0, 1, 2].map(commonest).join(", ")
    }

    /// What is said where a column has several, or angles are not in degrees.
    pub(crate) fn note(&self) -> Option<Note> {
        let columns = [0, 1, 2].map(|index| self.of(index).join(" and "));
        let plain = self.of(0).len() == 1
            && columns[1..].iter().all(|column| ["", "deg"].contains(&column.as_str()));
        let text = format!("md, incl and azi of the stations stand in {}", columns.join(", "));
        (!plain).then_some(Note::Read(text))
    }
}
