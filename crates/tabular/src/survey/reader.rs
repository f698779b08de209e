//! Reader of the cells of one table.

use wholestring::well::TieIn;
use wholestring_units::{Dimension, Unit, UnitSet, number_text};

use crate::{
    cells::number::{self, Fault, Style, is_null},
    cells::table::{Cell, Position, Row, Table},
    columns::column::Column,
    columns::layout::{Found, Layout},
    error::{TableError, TableErrorKind},
};

/// The style of the table's numbers.
pub(crate) fn style(table: &Table, layout: &Layout, rows: &[usize]) -> Result<Style, TableError> {
    let cells = || {
        rows.iter().flat_map(|&row| {
            let numbers = layout.columns.iter().filter(|found| !found.column.is_words());
            numbers.filter_map(move |found| table.rows[row].cells.get(found.index))
        })
    };
    let written = cells().filter(|cell| cell.number.is_none());
    number::style(written.map(|cell| cell.text.as_str())).map_err(|found| {
        let at = cells().find(|cell| cell.text == found).map(|cell| cell.at);
        table.source.error(TableErrorKind::AmbiguousComma { found: found.to_owned() }, at)
    })
}

/// Reads cells of one table.
pub(crate) struct Reader<'a> {
    pub(crate) table: &'a Table<'a>,
    pub(crate) style: Style,
}

impl Reader<'_> {
    /// The cell of a column in SI.
    pub(crate) fn value(&self, row: &Row, found: &Found) -> Result<f64, TableError> {
        let column = found.column;
        let error = |kind, at| Err(self.table.source.error(kind, Some(at)));
        let Some(cell) = row.cells.get(found.index).filter(|cell| !cell.is_empty()) else {
            return error(TableErrorKind::EmptyCell { column }, position(row, found));
        };
        let text = cell.text.clone();
        match self.read(cell, column).map(|number| found.unit.to_si(number)) {
            Ok(si) if si.is_finite() => Ok(si),
            Ok(_) | Err(Fault::NotFinite) => {
                error(TableErrorKind::NotFinite { column, found: text }, cell.at)
            }
            Err(Fault::NotANumber) => {
                error(TableErrorKind::NotANumber { column, found: text }, cell.at)
            }
        }
    }

    /// The number of a cell as written, in the unit of its column.
    pub(crate) fn read(&self, cell: &Cell, column: Column) -> Result<f64, Fault> {
        if let Some(number) = cell.number {
            return Ok(number);
        }
        match number::sided(&cell.text) {
            Some((text, is_other)) if matches!(column, Column::North | Column::East) => {
                let number = number::read(text, self.style)?;
                Ok(if is_other { -number } else { number })
            }
            _ => number::read(&cell.text, self.style),
        }
    }

    /// The number of a cell in SI, if it is one.
    pub(crate) fn number(&self, cell: &Cell, column: Column, unit: &Unit) -> Option<f64> {
        let number = self.read(cell, column).ok()?;
        Some(unit.to_si(number)).filter(|si| si.is_finite())
    }

    /// Whether a row has no number in a column: nothing, a word for it, or a null value.
    pub(crate) fn is_missing(&self, row: &Row, found: &Found) -> bool {
        row.cells.get(found.index).is_none_or(|cell| {
            number::is_null_word(cell.text.trim()) || self.is_null(cell, found.column)
        })
    }

    /// Whether a cell has a null value.
    pub(crate) fn is_null(&self, cell: &Cell, column: Column) -> bool {
        self.read(cell, column).is_ok_and(is_null)
    }

    pub(crate) fn out_of_range(
        &self,
        row: &Row,
        found: &Found,
        expected: &'static str,
    ) -> TableError {
        let written = format!("{} {}", row.text(found.index), found.unit.symbol);
        let kind = TableErrorKind::OutOfRange { column: found.column, found: written, expected };
        self.table.source.error(kind, Some(position(row, found)))
    }

    /// Position of the first station, from its row.
    pub(crate) fn tie_in(
        &self,
        layout: &Layout,
        row: &Row,
        md_m: f64,
        notes: &mut Vec<String>,
    ) -> Result<Option<TieIn>, TableError> {
        let first = |column| match layout.column(column) {
            Some(found)
                if row.cells.get(found.index).is_some_and(|cell| self.is_null(cell, column)) =>
            {
                Ok(None)
            }
            Some(found) if !row.text(found.index).is_empty() => self.value(row, found).map(Some),
            _ => Ok(None),
        };
        let tvd_m = first(Column::TrueVerticalDepth)?;
        let north_m = first(Column::North)?;
        let east_m = first(Column::East)?;
        if tvd_m.is_none() && north_m.is_none() && east_m.is_none() {
            return Ok(None);
        }
        let Some(tvd_m) = tvd_m.or((md_m == 0.0).then_some(0.0)) else {
            notes.push(
                "north and east are not used: the first station is below 0 and has no true \
                 vertical depth"
                    .to_owned(),
            );
            return Ok(None);
        };
        for (column, value) in [(Column::North, north_m), (Column::East, east_m)] {
            if value.is_none() {
                notes.push(format!("the first station has no {column}: taken as 0"));
            }
        }
        let tie_in =
            TieIn { north_m: north_m.unwrap_or(0.0), east_m: east_m.unwrap_or(0.0), tvd_m };
        let unit = layout.column(Column::MeasuredDepth).map(|found| found.unit);
        let unit = unit.unwrap_or(Dimension::Length.unit_in(UnitSet::Si));
        let length = |m: f64| {
            let number = (unit.from_si(m) * 1e6).round() / 1e6;
            format!("{} {}", number_text(number), unit.symbol)
        };
        notes.push(format!(
            "the first station is at true vertical depth {}, north {}, east {}",
            length(tie_in.tvd_m),
            length(tie_in.north_m),
            length(tie_in.east_m)
        ));
        if tie_in.is_on_map() {
            notes.push(
                "north and east are coordinates of a map, farther than 100 km from their origin: \
                 loads do not depend on them, and drawings are relative to the first station"
                    .to_owned(),
            );
        }
        Ok(Some(tie_in))
    }
}

/// The place of a cell of a row.
pub(crate) fn position(row: &Row, found: &Found) -> Position {
    row.cells.get(found.index).map_or(row.end, |cell| cell.at)
}

/// The place of a whole row: its first cell that is not empty.
pub(crate) fn whole(row: &Row) -> Position {
    row.cells.iter().find(|cell| !cell.is_empty()).map_or(row.end, |cell| cell.at)
}
