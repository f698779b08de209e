//! The sheets of a workbook as rows of texts, for tables that are no surveys, tallies or readings.

use crate::{
    cells::{self, workbook},
    error::TableError,
};

/// A visible sheet of a workbook, as texts.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetText {
    /// What it is called.
    pub name: String,
    /// Its rows from the first on, as spreadsheets count them: hidden rows are empty, hidden columns
    /// are left out. A number is written in full, a date as ISO 8601 has it.
    pub rows: Vec<Vec<String>>,
    /// What of it is not read, in sentences for people.
    pub notes: Vec<String>,
}

/// What stands for the result of a formula that was never calculated.
const UNCALCULATED: &str = "a formula that was never calculated";

/// Whether a file that begins so is a workbook, or another archive: by its content, not by its name.
pub fn is_workbook(head: &[u8]) -> bool {
    workbook::is_workbook(head)
}

/// The visible sheets of a workbook; none of a text.
///
/// # Errors
/// It is a workbook that cannot be read, or holds more than is read.
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
