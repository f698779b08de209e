//! The sheets of an Excel workbook as rows of cells.

use std::collections::BTreeMap;
use std::io::Cursor;

use calamine::{Data, Reader, SheetType, Xls, Xlsx};

use super::compound;
use super::error::SurveyErrorKind;
use super::table::{Cell, Position, Row};
use crate::caught::caught;

/// A sheet with its rows, empty ones above the last included.
#[derive(Debug, Clone)]
pub(super) struct Sheet {
    pub(super) name: String,
    pub(super) rows: Vec<Row>,
}

/// Cells further down or to the right are not read: no survey has so many stations or columns, and
/// a single cell at the far corner would make a table of the whole sheet.
const ROWS: u32 = 200_000;
const COLUMNS: u32 = 500;

/// Whether the bytes begin as a workbook does: a zip archive or a compound file.
pub(super) fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1")
}

/// The workbook's sheets.
pub(super) fn sheets(bytes: &[u8]) -> Result<Vec<Sheet>, SurveyErrorKind> {
    if bytes.is_empty() {
        return Err(SurveyErrorKind::Empty);
    }
    // The reader of workbooks is not ours, and a damaged file may make it panic.
    let sheets = caught(|| {
        if bytes.starts_with(b"PK") {
            xlsx(bytes)
        } else {
            xls(bytes)
        }
    });
    match sheets {
        Ok(Ok(sheets)) => Ok(sheets),
        Ok(Err(reason)) => Err(SurveyErrorKind::NotAWorkbook { reason }),
        Err(_) => Err(SurveyErrorKind::NotAWorkbook {
            reason: "it is damaged".to_owned(),
        }),
    }
}

fn xlsx(bytes: &[u8]) -> Result<Vec<Sheet>, String> {
    let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut sheets = Vec::new();
    for name in worksheets(workbook.sheets_metadata()) {
        // Cell by cell: the whole range of a sheet is as large as its farthest cell says.
        let mut reader = workbook
            .worksheet_cells_reader(&name)
            .map_err(|error| error.to_string())?;
        let mut cells = BTreeMap::new();
        while let Some(cell) = reader.next_cell().map_err(|error| error.to_string())? {
            let (row, column) = cell.get_position();
            if let Some(cell) = self::cell(&Data::from(cell.get_value().clone()), row, column) {
                cells.insert((row, column), cell);
            }
        }
        sheets.push(Sheet {
            name,
            rows: rows(cells),
        });
    }
    Ok(sheets)
}

fn xls(bytes: &[u8]) -> Result<Vec<Sheet>, String> {
    if !compound::is_plausible(bytes) {
        return Err("it holds no workbook, or it is damaged".to_owned());
    }
    let mut workbook = Xls::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut sheets = Vec::new();
    for name in worksheets(workbook.sheets_metadata()) {
        let range = workbook
            .worksheet_range(&name)
            .map_err(|error| error.to_string())?;
        let (top, left) = range.start().unwrap_or((0, 0));
        let cells = range
            .used_cells()
            .filter_map(|(row, column, data)| {
                let (row, column) = (top + row as u32, left + column as u32);
                Some(((row, column), cell(data, row, column)?))
            })
            .collect();
        sheets.push(Sheet {
            name,
            rows: rows(cells),
        });
    }
    Ok(sheets)
}

/// The names of the sheets that hold cells and not a chart.
fn worksheets(sheets: &[calamine::Sheet]) -> Vec<String> {
    let holds_cells = |sheet: &&calamine::Sheet| sheet.typ == SheetType::WorkSheet;
    sheets
        .iter()
        .filter(holds_cells)
        .map(|sheet| sheet.name.clone())
        .collect()
}

/// One cell, unless it is empty or too far out.
fn cell(data: &Data, row: u32, column: u32) -> Option<Cell> {
    if row >= ROWS || column >= COLUMNS {
        return None;
    }
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
fn rows(cells: BTreeMap<(u32, u32), Cell>) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for ((row, column), cell) in cells {
        let (row, column) = (row as usize, column as usize);
        while rows.len() <= row {
            rows.push(Row {
                cells: Vec::new(),
                end: Position(rows.len(), 0),
            });
        }
        let row = &mut rows[row];
        while row.cells.len() < column {
            let at = Position(row.end.0, row.cells.len());
            row.cells.push(Cell {
                text: String::new(),
                number: None,
                at,
            });
        }
        row.cells.push(cell);
        row.end.1 = row.cells.len();
    }
    rows
}
