//! Positions of a table's columns, their units, and the first row of numbers.

use wholestring_units::Unit;

use crate::cells::number;
use crate::cells::table::{Position, Row, Table};
use crate::columns::header::Header;
use crate::columns::heading::{self, HeadingUnit};
use crate::columns::names::Sort;
use crate::error::{TableError, TableErrorKind};
use crate::{columns::column::Column, survey::said::Said};

/// One column of the survey in the table.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    pub(crate) column: Column,
    /// Index of its cell in each row.
    pub(crate) index: usize,
    pub(crate) unit: &'static Unit,
}

/// Positions of the columns and of the data.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    pub(crate) columns: Vec<Found>,
    /// The first row below the header and the units.
    pub(crate) data: usize,
    /// The header's texts, by which a header repeated further down is recognised.
    pub(crate) header: Vec<String>,
    pub(crate) notes: Vec<String>,
}

impl Layout {
    pub(crate) fn column(&self, column: Column) -> Option<&Found> {
        self.columns.iter().find(|found| found.column == column)
    }

    /// Checks that a row of headings or units below the first row of data, as of a second table or
    /// page, has the units of this one.
    ///
    /// # Errors
    /// The first cell with another unit.
    pub(crate) fn check_units(
        &self,
        table: &Table,
        row: &Row,
        sort: &Sort,
    ) -> Result<(), TableError> {
        for found in self.columns.iter().filter(|found| !found.column.is_words()) {
            let Some(cell) = row.cells.get(found.index) else { continue };
            let headed = heading::recognise(&cell.text, sort).and_then(|heading| {
                match (heading.unit, heading.column == found.column) {
                    (HeadingUnit::Unit(unit), true) => Some(unit),
                    _ => None,
                }
            });
            let bare = heading::bare_unit(&cell.text);
            let unit = headed.or_else(|| found.column.dimension().find_unit(bare));
            if let Some(unit) = unit.filter(|unit| *unit != found.unit) {
                let (column, above, below) = (found.column, found.unit.symbol, unit.symbol);
                let kind = TableErrorKind::UnitChanges { column, above, below };
                return Err(table.source.error(kind, Some(cell.at)));
            }
        }
        Ok(())
    }

    /// Whether a column of numbers is at this index.
    pub(crate) fn is_of_numbers(&self, index: usize) -> bool {
        self.columns.iter().any(|found| found.index == index && !found.column.is_words())
    }
}

/// Determines the layout below a header: its units, and the beginning of the numbers.
pub(crate) fn below(table: &Table, header: Header, said: &Said) -> Result<Layout, TableError> {
    let row = table.source.row_name(table.rows[header.row].end);
    let mut notes = vec![table.note(&format!("header in {row}"))];
    for text in &header.passed_over {
        notes.push(format!("the column '{text}' is not used"));
    }
    let (units_row, data) = units_row(table, &header);

    let mut columns = Vec::new();
    let mut in_degrees = Vec::new();
    let mut as_said = Vec::new();
    for (index, text, heading) in &header.headings {
        let column = heading.column;
        let header_at = header_position(table, header.row, *index);
        let in_row = match units_row {
            Some(row) => unit_in_row(table, row, *index, column)?,
            None => None,
        };
        let unit = match (&heading.unit, in_row) {
            (HeadingUnit::Wrong { found, is }, _) => {
                let kind = TableErrorKind::WrongUnit { column, found: found.clone(), is: *is };
                return Err(table.source.error(kind, Some(header_at)));
            }
            (HeadingUnit::Unit(in_header), Some((in_row, at))) if *in_header != in_row => {
                let kind = TableErrorKind::UnitConflict {
                    column,
                    header: in_header.symbol,
                    row: in_row.symbol,
                };
                return Err(table.source.error(kind, Some(at)));
            }
            (HeadingUnit::Unit(unit), _) => *unit,
            (HeadingUnit::None, Some((unit, _))) => unit,
            (HeadingUnit::None, None) => match column {
                _ if column.is_words() => named_unit(column, ""),
                _ if column.is_read() => {
                    let kind = TableErrorKind::MissingReadingUnit { column, header: text.clone() };
                    return Err(table.source.error(kind, Some(header_at)));
                }
                Column::Inclination | Column::Azimuth => {
                    in_degrees.push(column.to_string());
                    named_unit(column, "deg")
                }
                _ => match said.length_unit_of(column) {
                    Some(unit) => {
                        as_said.push((column.to_string(), unit));
                        unit
                    }
                    None => {
                        let kind = TableErrorKind::MissingUnit { column, header: text.clone() };
                        return Err(table.source.error(kind, Some(header_at)));
                    }
                },
            },
        };
        if let Some(chosen) = said.length_unit
            && column == Column::MeasuredDepth
            && chosen != unit
        {
            let kind = TableErrorKind::OtherUnit { column, file: unit.symbol, said: chosen.symbol };
            return Err(table.source.error(kind, Some(header_at)));
        }
        notes.push(match column.is_words() {
            true => format!("{column} from '{text}'"),
            false => format!("{column} from '{text}' in {}", unit.symbol),
        });
        columns.push(Found { column, index: *index, unit });
    }
    for units in as_said.chunk_by(|one, next| one.1 == next.1) {
        let columns: Vec<&str> = units.iter().map(|(column, _)| column.as_str()).collect();
        let unit = units[0].1.symbol;
        notes.push(format!("no unit for {}: read in {unit} as given", columns.join(" and ")));
    }
    if !in_degrees.is_empty() {
        notes.push(format!("no unit for {}: read in degrees", in_degrees.join(" and ")));
    }
    let read: Vec<usize> = columns.iter().map(|found| found.index).collect();
    table.check_calculated(&read, header.row)?;
    Ok(Layout { columns, data, header: header.texts, notes })
}

/// Returns the layout of three columns of numbers without a header, from their first row on; `None`
/// if there are more columns, or a header that names none of them. A missing unit of the depths is
/// an error.
pub(crate) fn without_header(table: &Table, said: &Said) -> Option<Result<Layout, TableError>> {
    let first = table.rows.iter().position(|row| {
        !row.is_empty() && row.texts().count() > 1 && row.texts().all(number::is_number)
    })?;
    let headed = table.rows[..first]
        .iter()
        .any(|row| !row.is_comment() && row.texts().count() >= Column::NEEDED.len());
    if headed || table.rows[first].texts().count() != Column::NEEDED.len() {
        return None;
    }
    let row = &table.rows[first];
    let cells = &row.cells;
    let Some(length_unit) = said.length_unit else {
        let at = cells.iter().find(|cell| !cell.is_empty());
        let at = at.map_or(row.end, |cell| cell.at);
        return Some(Err(table.source.error(TableErrorKind::NoUnits, Some(at))));
    };
    let filled = cells.iter().enumerate().filter(|(_, cell)| !cell.is_empty());
    let columns = filled
        .zip(Column::NEEDED)
        .map(|((index, _), column)| {
            let unit = if column == Column::MeasuredDepth {
                length_unit
            } else {
                named_unit(column, "deg")
            };
            Found { column, index, unit }
        })
        .collect();
    let notes = vec![
        table.note("no header"),
        format!(
            "three columns read as measured depth in {} as given, inclination in deg, azimuth in \
             deg",
            length_unit.symbol
        ),
    ];
    Some(Ok(Layout { columns, data: first, header: Vec::new(), notes }))
}

/// The row of units below a header, if there is one, and the row after it.
fn units_row(table: &Table, header: &Header) -> (Option<usize>, usize) {
    let below = header.row + 1;
    let is_blank = |row: usize| table.rows[row].is_empty() || table.rows[row].is_rule();
    let Some(row) = (below..table.rows.len()).find(|&row| !is_blank(row)) else {
        return (None, below);
    };
    let mut cells = header
        .headings
        .iter()
        .map(|(index, _, heading)| (heading.column, table.rows[row].text(*index)))
        .filter(|(_, text)| !text.is_empty())
        .peekable();
    let mut names_unit = false;
    let mut names_number = false;
    for (column, text) in cells.by_ref() {
        let unit = heading::bare_unit(text);
        names_unit |= column.dimension().find_unit(unit).is_some();
        names_unit |= heading::dimension_of(unit).is_some();
        names_number |= number::is_number(text);
    }
    if names_unit && !names_number { (Some(row), row + 1) } else { (None, below) }
}

/// The unit in a row of units, and its place.
fn unit_in_row(
    table: &Table,
    row: usize,
    index: usize,
    column: Column,
) -> Result<Option<(&'static Unit, Position)>, TableError> {
    let Some(cell) = table.rows[row].cells.get(index) else {
        return Ok(None);
    };
    let text = heading::bare_unit(&cell.text);
    if text.is_empty() || text.chars().all(|c| "-=_".contains(c)) {
        return Ok(None);
    }
    match column.dimension().find_unit(text) {
        Some(unit) => Ok(Some((unit, cell.at))),
        None => {
            let is = heading::dimension_of(text);
            let kind = TableErrorKind::WrongUnit { column, found: text.to_owned(), is };
            Err(table.source.error(kind, Some(cell.at)))
        }
    }
}

fn header_position(table: &Table, row: usize, index: usize) -> Position {
    let row = &table.rows[row];
    row.cells.get(index).map_or(row.end, |cell| cell.at)
}

/// A unit of the column by its symbol; for a foreign symbol, the dimension's first unit.
fn named_unit(column: Column, symbol: &str) -> &'static Unit {
    let dimension = column.dimension();
    dimension.find_unit(symbol).unwrap_or(&dimension.units()[0])
}
