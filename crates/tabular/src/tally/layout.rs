//! Units of a tally's columns: in the headings, in a row below them, or given by the user.

use wholestring_units::Unit;

use super::header::{Headed, Header, OfUnit, unit_of};
use crate::{
    cells::{
        number,
        table::{Position, Row, Source, Table, line_starts},
    },
    columns::{column::Column, heading},
    error::{TableError, TableErrorKind},
};

/// A column with its unit, if it is known.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Laid {
    pub(crate) column: Column,
    pub(crate) index: usize,
    pub(crate) heading: String,
    pub(crate) unit: Option<OfUnit>,
}

/// Positions of the columns and of the data.
pub(crate) struct Layout {
    pub(crate) columns: Vec<Laid>,
    /// The first row below the header and the units.
    pub(crate) data: usize,
    pub(crate) notes: Vec<String>,
}

/// Determines the layout below a header. `said` returns the unit given by the user for a column.
pub(crate) fn below(
    table: &Table,
    header: &Header,
    said: &mut dyn FnMut(Column) -> Option<&'static Unit>,
) -> Result<Layout, TableError> {
    let place = table.source.row_name(table.rows[header.row].end);
    let mut notes = vec![table.note(&format!("header in {place}"))];
    let next = (header.row + 1..table.rows.len())
        .find(|&row| !table.rows[row].is_empty() && !table.rows[row].is_rule());
    let units = next.filter(|&row| is_units(&table.rows[row], &header.columns));
    let mut columns = Vec::new();
    for headed in &header.columns {
        let at = table.rows[header.row].cells.get(headed.index).map(|cell| cell.at);
        let error = |kind, at: Option<Position>| Err(table.source.error(kind, at));
        let mut column = headed.column;
        if let Some(found) = &headed.wrong {
            let is = heading::dimension_of(found);
            let kind = TableErrorKind::WrongUnit { column, found: found.clone(), is };
            return error(kind, at);
        }
        let mut unit = headed.unit;
        if let Some(row) = units
            && !column.is_words()
            && let Some(cell) = table.rows[row].cells.get(headed.index)
        {
            let text = heading::bare_unit(&cell.text);
            let is_drawn = text.chars().all(|c| "-=_–".contains(c));
            match unit_of(column, text) {
                Some((actual, in_row)) => {
                    if let Some((in_header, _)) = unit.filter(|unit| *unit != in_row) {
                        let (header, row) = (in_header.symbol, in_row.0.symbol);
                        let kind = TableErrorKind::UnitConflict { column, header, row };
                        return error(kind, Some(cell.at));
                    }
                    (column, unit) = (actual, Some(in_row));
                }
                None if is_drawn => {}
                None => {
                    let is = heading::dimension_of(text);
                    let kind = TableErrorKind::WrongUnit { column, found: text.to_owned(), is };
                    return error(kind, Some(cell.at));
                }
            }
        }
        if !column.is_words()
            && let Some(chosen) = said(column)
        {
            match unit {
                Some((file, _)) if file != chosen => {
                    let kind = TableErrorKind::OtherUnit {
                        column,
                        file: file.symbol,
                        said: chosen.symbol,
                    };
                    return error(kind, at);
                }
                _ => unit = Some((chosen, column.dimension())),
            }
        }
        let heading = headed.text.clone();
        notes.push(match (column.is_words(), unit) {
            (true, _) => format!("{column} from '{heading}'"),
            (false, Some((unit, _))) => format!("{column} from '{heading}' in {}", unit.symbol),
            (false, None) => format!("{column} from '{heading}', the unit in each cell"),
        });
        columns.push(Laid { column, index: headed.index, heading, unit });
    }
    let read: Vec<usize> = columns.iter().map(|laid| laid.index).collect();
    table.check_calculated(&read, header.row)?;
    let data = units.map_or(header.row, |row| row) + 1;
    Ok(Layout { columns, data, notes })
}

/// Whether a row is one of units: at least one, and no number.
pub(crate) fn is_units(row: &Row, columns: &[Headed]) -> bool {
    let cells = || {
        let numbers = columns.iter().filter(|headed| !headed.column.is_words());
        numbers.map(|headed| (headed.column, heading::bare_unit(row.text(headed.index))))
    };
    cells().any(|(column, text)| !text.is_empty() && unit_of(column, text).is_some())
        && !row.texts().any(|text| number::is_number(text) || text.len() > 20)
}

// Places of the cells of a table, in words.

/// Finds the line of a position without scanning the text each time.
pub(crate) struct Lines<'a> {
    source: Source<'a>,
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    pub(crate) fn of(source: Source<'a>) -> Self {
        let starts = match source {
            Source::Text { text, .. } => line_starts(text).collect(),
            Source::Sheet { .. } => Vec::new(),
        };
        Self { source, starts }
    }

    /// `line 5`, `row 5 of sheet 'BHA'`.
    pub(crate) fn row(&self, at: Position) -> String {
        match self.source {
            Source::Text { .. } => format!("line {}", self.line(at)),
            Source::Sheet { .. } => self.source.row_name(at),
        }
    }

    /// `line 5, column 'OD'`, `sheet 'BHA', cell C5`.
    pub(crate) fn cell(&self, at: Position, heading: &str) -> String {
        match self.source {
            Source::Text { .. } => format!("line {}, column '{heading}'", self.line(at)),
            Source::Sheet { .. } => self.source.place(at).to_string(),
        }
    }

    fn line(&self, at: Position) -> usize {
        self.starts.partition_point(|&start| start <= at.0)
    }
}
