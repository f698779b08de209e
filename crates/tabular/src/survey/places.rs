//! Places of the stations of a survey in its file.

use wholestring_units::{Dimension, UnitSet, number_text};

use crate::{
    cells::table::{Position, Row, Source, Table},
    error::Place,
    survey::reader::whole,
};

/// The row of each station in its file.
#[derive(Debug, Clone, PartialEq)]
pub struct StationPlaces {
    /// The file, if it is a text.
    text: Option<String>,
    /// The sheet, in a workbook.
    sheet: String,
    rows: Vec<Position>,
}

impl StationPlaces {
    /// Places of the stations in these rows.
    pub(crate) fn new(table: &Table, rows: &[usize]) -> Self {
        let (text, sheet) = match table.source {
            Source::Text { text, .. } => (Some(text.to_owned()), String::new()),
            Source::Sheet { sheet, .. } => (None, sheet.to_owned()),
        };
        let is_text = text.is_some();
        let position = |row: &Row| match (is_text, row.cells.iter().rfind(|cell| !cell.is_empty()))
        {
            (true, Some(last)) => Position(whole(row).0, last.at.1),
            _ => whole(row),
        };
        Self { text, sheet, rows: rows.iter().map(|&row| position(&table.rows[row])).collect() }
    }

    fn source(&self) -> Source<'_> {
        match &self.text {
            Some(text) => Source::Text { file: "", text },
            None => Source::Sheet { file: "", sheet: &self.sheet, unread: "" },
        }
    }

    /// The row of a station; `None` if there is no such station.
    pub fn place(&self, index: usize) -> Option<Place> {
        Some(self.source().place(*self.rows.get(index)?))
    }

    /// The row of a station in words: `line 5`, `row 5 of sheet 'Survey'`.
    pub fn row_name(&self, index: usize) -> String {
        self.rows.get(index).map_or_else(String::new, |row| self.source().row_name(*row))
    }

    /// The file as text, to which a [`Place::Text`] refers; `None` for a workbook.
    pub fn text(&self) -> Option<&str> {
        self.text.as_deref()
    }
}

// Depths and angles of surveys in sentences.

/// A measured depth to a tenth of its unit.
pub(crate) fn depth(md_m: f64, set: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(set);
    // Adding zero removes the sign of a rounded one.
    let number = (unit.from_si(md_m) * 10.0).round() / 10.0 + 0.0;
    format!("{} {}", number_text(number), unit.symbol)
}

/// A difference of positions to a hundredth of its unit.
pub(crate) fn difference(length_m: f64, set: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(set);
    format!("{:.2} {}", unit.from_si(length_m), unit.symbol)
}

/// A dogleg severity to a tenth of its unit.
pub(crate) fn severity(rad_per_m: f64, set: UnitSet) -> String {
    let unit = Dimension::DoglegSeverity.unit_in(set);
    format!("{:.1} {}", unit.from_si(rad_per_m), unit.symbol)
}

/// An azimuth of up to two turns, reduced to the range of azimuths in a case, which ends at one; and
/// whether it was reduced.
pub fn within_a_turn(azimuth_rad: f64) -> (f64, bool) {
    const TURN_RAD: f64 = std::f64::consts::TAU;
    match azimuth_rad > TURN_RAD {
        true => (azimuth_rad - TURN_RAD, true),
        false => (azimuth_rad, false),
    }
}

/// An angle in degrees to a hundredth.
pub(crate) fn degrees(angle_rad: f64) -> String {
    number_text((angle_rad.to_degrees() * 100.0).round() / 100.0)
}
