//! The sheets of a workbook as rows of texts, for tables other than surveys, tallies and readings.

use crate::{
    cells::{self, workbook},
    error::TableError,
};

/// A visible sheet of a workbook, as texts.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetText {
    /// Its name.
    pub name: String,
    /// Its rows from the first on, as spreadsheets count them: hidden rows are empty, hidden
    /// columns are left out. A number is written in full, a date in ISO 8601.
    pub rows: Vec<Vec<String>>,
    /// Notes on contents that are not read.
    pub notes: Vec<String>,
}

/// Text for the result of a formula that was never calculated.
pub const UNCALCULATED: &str = "a formula that was never calculated";

/// Whether a file with these first bytes is a workbook or another archive, regardless of its name.
pub fn is_workbook(head: &[u8]) -> bool {
    workbook::is_workbook(head)
}

/// Returns the visible sheets of a workbook; none of a text.
///
/// # Errors
/// It is a workbook that cannot be read, or exceeds a limit.
pub fn sheets(bytes: &[u8], name: &str) -> Result<Vec<SheetText>, TableError> {
    if !cells::is_workbook(bytes, name) {
        return Ok(Vec::new());
    }
    let workbook::Workbook { sheets, hidden } = workbook::read(bytes, workbook::Dates::Written)
        .map_err(|kind| TableError::new(name, kind, None, None))?;
    let hidden = workbook::hidden_sheets(&hidden);
    let texts = sheets.into_iter().map(|sheet| {
        let mut rows: Vec<Vec<String>> = Vec::new();
        for row in sheet.rows {
            rows.resize(rows.len().max(row.end.0), Vec::new());
            let cells = row.cells.into_iter().map(|cell| match cell.is_uncalculated {
                true => UNCALCULATED.to_owned(),
                false => cell.text,
            });
            rows.push(cells.collect());
        }
        let notes = sheet.notes.into_iter().chain(sheet.hidden).chain(hidden.clone()).collect();
        SheetText { name: sheet.name, rows, notes }
    });
    Ok(texts.collect())
}
