//! Kinds of the tables of a file: surveys, tallies, readings.

use wholestring_units::Unit;

use crate::{
    cells::{
        self, fixed,
        table::{BLANKS, Source, Table},
    },
    columns::{
        column::Column,
        header::{self, headed},
        names::{READINGS, SURVEY},
    },
    error::{TableError, TableErrorKind},
    tally::{self, ImportedTally},
};

/// Tables of a file, recognised by their headings.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Held {
    /// Sheets with the columns of a survey; one empty name for a text.
    pub surveys: Vec<String>,
    /// Sheets with the columns of a tally.
    pub tallies: Vec<String>,
    /// Sheets with weights or torques against the depth of the bit.
    pub readings: Vec<String>,
    /// If there is none of these: the error of the table that resembles a tally most, and more than
    /// a survey.
    pub nearly_tally: Option<TableError>,
    /// Contents of a workbook that are not read and might be missed: hidden sheets, rows and
    /// columns, formulas without a result. Empty if there are none.
    pub unread: String,
}

/// Determines the tables of a file by their headings alone.
///
/// # Errors
/// It is neither a text nor a workbook, or exceeds a limit.
pub fn held(bytes: &[u8], name: &str) -> Result<Held, TableError> {
    of_tables(bytes, name, |tables, unread| {
        let mut held = Held { unread: unread.to_owned(), ..Held::default() };
        for table in tables {
            let name = match table.source {
                Source::Sheet { sheet, .. } => sheet.to_owned(),
                Source::Text { .. } => String::new(),
            };
            let push = |sheets: &mut Vec<String>| {
                if !sheets.contains(&name) {
                    sheets.push(name.clone());
                }
            };
            if header::find(table, &SURVEY).is_ok() {
                push(&mut held.surveys);
            }
            if keeps_empty_cells(table) && matches!(tally::find(table), tally::Found::Header(_)) {
                push(&mut held.tallies);
            }
            if has_readings(table) {
                push(&mut held.readings);
            }
        }
        if held.surveys.is_empty() && held.tallies.is_empty() && held.readings.is_empty() {
            held.nearly_tally = nearly_tally(tables);
        }
        held
    })
}

/// Reads a tally from the named sheet, or from the first table that is one.
///
/// `said` returns the unit given by the user for a column of the tally.
///
/// # Errors
/// It is not a tally, or something in it cannot be read; with its place.
pub fn read_tally(
    bytes: &[u8],
    name: &str,
    sheet: Option<&str>,
    said: &mut dyn FnMut(Column) -> Option<&'static Unit>,
) -> Result<ImportedTally, TableError> {
    of_tables(bytes, name, |tables, unread| {
        let is_it = |table: &&Table| match (table.source, sheet) {
            (Source::Sheet { sheet, .. }, Some(name)) => sheet == name,
            _ => true,
        };
        let tables = || tables.iter().filter(|table| keeps_empty_cells(table));
        tables().filter(is_it).find_map(|table| tally::read(table, said)).unwrap_or_else(|| {
            let found = "no row names the columns of a tally";
            let kind = TableErrorKind::NoTally { found };
            Err(TableError::new(name, kind, None, None).with_unread(unread))
        })
    })?
}

/// Applies a function to the tables of a file: a text is also cut into aligned columns.
fn of_tables<R>(
    bytes: &[u8],
    name: &str,
    read: impl FnOnce(&[Table], &str) -> R,
) -> Result<R, TableError> {
    if cells::is_workbook(bytes, name) {
        return cells::of_workbook(bytes, name, |tables, book| read(tables, &book.unread));
    }
    cells::of_text(bytes, name, |tables, source| {
        let mut tables = tables.to_vec();
        if let Source::Text { text, .. } = source {
            tables.push(fixed::cut(source, text));
        }
        read(&tables, "")
    })
}

/// Whether an empty cell counts as a cell: with words separated by any blanks it does not, and a
/// tally has many.
fn keeps_empty_cells(table: &Table) -> bool {
    table.parted_by != Some(BLANKS)
}

/// Whether the table has a bit depth, and a weight or a torque.
fn has_readings(table: &Table) -> bool {
    let Ok(header) = header::find(table, &READINGS) else { return false };
    let is_measured = |column: &Column| {
        matches!(
            column,
            Column::PickUp
                | Column::SlackOff
                | Column::Rotating
                | Column::Torque
                | Column::TorqueOnBottom
        )
    };
    header.headings.iter().any(|(_, _, heading)| is_measured(&heading.column))
}

/// The error of the header that resembles a tally's most.
fn nearly_tally(tables: &[Table]) -> Option<TableError> {
    let as_survey = match headed(tables, &SURVEY) {
        header::Headed::Nearest(partial, _) => partial.count,
        _ => 0,
    };
    let tables = tables.iter().filter(|table| keeps_empty_cells(table));
    let nearest = tables.filter_map(|table| match tally::find(table) {
        tally::Found::Nearest { count, row, missing, texts } => {
            Some((count, table, row, missing, texts))
        }
        _ => None,
    });
    let (count, table, row, missing, texts) = nearest.max_by_key(|(count, ..)| *count)?;
    if count <= as_survey.max(1) {
        return None;
    }
    let texts: Vec<String> = texts.into_iter().filter(|text| !text.is_empty()).collect();
    let kind = TableErrorKind::MissingColumn { column: missing, headers: texts, nearest: None };
    Some(table.source.error(kind, table.rows.get(row).map(crate::survey::reader::whole)))
}
