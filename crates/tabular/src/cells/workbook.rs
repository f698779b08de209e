//! The sheets of an Excel workbook as rows of cells.

use std::collections::BTreeMap;
use std::io::Cursor;

use calamine::{Data, DataRef, Reader, SheetType, Xls, Xlsx};
use wholestring_contain::contain;

use crate::cells::limits::{self, Budget, too_much};
use crate::cells::table::{Cell, Position, Row};
use crate::error::{TableErrorKind, letters};
use crate::{cells::archive, cells::compound, cells::records};

/// A sheet with its rows, empty ones above the last included.
#[derive(Debug)]
pub(crate) struct Sheet {
    pub(crate) name: String,
    pub(crate) rows: Vec<Row>,
    /// What of it is not read.
    pub(crate) notes: Vec<String>,
}

/// Whether the bytes begin as a workbook does: a zip archive or a compound file.
pub(crate) fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(compound::MARK)
}

/// The workbook's sheets.
pub(crate) fn sheets(bytes: &[u8]) -> Result<Vec<Sheet>, TableErrorKind> {
    if bytes.is_empty() {
        return Err(TableErrorKind::Empty);
    }
    // A folder in a browser holds texts, and what a browser fetches is small: readers of workbooks
    // would be a third of it.
    if cfg!(all(target_family = "wasm", target_os = "unknown")) {
        return Err(unreadable("in a browser alone none can: save its sheet as CSV"));
    }
    // The reader of workbooks is not ours, and a damaged file may make it panic.
    let sheets = contain(|| if bytes.starts_with(b"PK") { xlsx(bytes) } else { xls(bytes) });
    sheets.unwrap_or_else(|_| Err(unreadable("it is damaged")))
}

fn unreadable(reason: impl ToString) -> TableErrorKind {
    TableErrorKind::NotAWorkbook { reason: reason.to_string() }
}

fn xlsx(bytes: &[u8]) -> Result<Vec<Sheet>, TableErrorKind> {
    archive::check(bytes)?;
    let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(unreadable)?;
    let mut sheets = Vec::new();
    let mut budget = Budget::default();
    for name in worksheets(workbook.sheets_metadata())? {
        // Cell by cell: the whole range of a sheet is as large as its farthest cell says.
        let mut reader = workbook.worksheet_cells_reader(&name).map_err(unreadable)?;
        let mut cells = BTreeMap::new();
        let mut far = Vec::new();
        while let Some(cell) = reader.next_cell().map_err(unreadable)? {
            budget.cells(1)?;
            // Before it is copied: many cells may show one long text.
            if let DataRef::SharedString(text) = cell.get_value() {
                budget.text(text.len())?;
            }
            let (row, column) = cell.get_position();
            if is_far(row, column) {
                // One is enough to say it.
                if far.is_empty() && !matches!(cell.get_value(), DataRef::Empty) {
                    far.push(far_note(row, column));
                }
                continue;
            }
            if let Some(cell) = self::cell(&Data::from(cell.get_value().clone()), row, column) {
                cells.insert((row, column), cell);
            }
        }
        let rows = rows(cells, &mut budget)?;
        sheets.push(Sheet { name, rows, notes: far });
    }
    Ok(sheets)
}

fn xls(bytes: &[u8]) -> Result<Vec<Sheet>, TableErrorKind> {
    let mut stream = compound::workbook_stream(bytes)?;
    records::check(&mut stream)?;
    let file = compound::file_of(&stream);
    drop(stream);
    let mut workbook = Xls::new(Cursor::new(file)).map_err(unreadable)?;
    let mut sheets = Vec::new();
    let mut budget = Budget::default();
    for name in worksheets(workbook.sheets_metadata())? {
        let range = workbook.worksheet_range(&name).map_err(unreadable)?;
        let (top, left) = range.start().unwrap_or((0, 0));
        let cells = range
            .used_cells()
            .filter_map(|(row, column, data)| {
                let (row, column) = (top + row as u32, left + column as u32);
                Some(((row, column), cell(data, row, column)?))
            })
            .collect();
        let rows = rows(cells, &mut budget)?;
        sheets.push(Sheet { name, rows, notes: Vec::new() });
    }
    Ok(sheets)
}

/// The names of the sheets that hold cells and not a chart.
fn worksheets(sheets: &[calamine::Sheet]) -> Result<Vec<String>, TableErrorKind> {
    if sheets.len() > limits::SHEETS {
        return Err(too_much(sheets.len(), "sheets", limits::SHEETS));
    }
    let holds_cells = |sheet: &&calamine::Sheet| sheet.typ == SheetType::WorkSheet;
    let names = sheets.iter().filter(holds_cells);
    Ok(names.map(|sheet| sheet.name.clone()).collect())
}

/// Whether a cell is too far out to be read: a single one at the far corner would make a table of the
/// whole sheet. Old workbooks have no such cells.
fn is_far(row: u32, column: u32) -> bool {
    row as usize >= limits::ROWS || column >= limits::COLUMNS
}

/// What is said of the first such cell.
fn far_note(row: u32, column: u32) -> String {
    format!(
        "cells beyond row {} or column {} are not read; one is {}{}",
        limits::ROWS,
        letters(limits::COLUMNS),
        letters(column + 1),
        row + 1
    )
}

/// One cell, unless it is empty.
fn cell(data: &Data, row: u32, column: u32) -> Option<Cell> {
    let (text, number) = match data {
        Data::Empty => return None,
        Data::Float(number) => (number.to_string(), Some(*number)),
        Data::Int(number) => (number.to_string(), Some(*number as f64)),
        Data::String(text) | Data::DateTimeIso(text) | Data::DurationIso(text) => {
            (text.split_whitespace().collect::<Vec<_>>().join(" "), None)
        }
        Data::Bool(value) => (value.to_string(), None),
        Data::DateTime(_) => ("a date".to_owned(), None),
        Data::Error(error) => (error.to_string(), None),
    };
    let at = Position(row as usize, column as usize);
    (!text.is_empty()).then_some(Cell { text, number, at })
}

/// Cells as rows without gaps.
fn rows(
    cells: BTreeMap<(u32, u32), Cell>,
    budget: &mut Budget,
) -> Result<Vec<Row>, TableErrorKind> {
    let mut rows: Vec<Row> = Vec::new();
    for ((row, column), cell) in cells {
        let (row, column) = (row as usize, column as usize);
        while rows.len() <= row {
            rows.push(Row { cells: Vec::new(), end: Position(rows.len(), 0) });
        }
        let row = &mut rows[row];
        budget.cells(column - row.cells.len())?;
        while row.cells.len() < column {
            let at = Position(row.end.0, row.cells.len());
            row.cells.push(Cell { text: String::new(), number: None, at });
        }
        row.cells.push(cell);
        row.end.1 = row.cells.len();
    }
    Ok(rows)
}
