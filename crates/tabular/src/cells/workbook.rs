//! The sheets of an Excel workbook as rows of cells.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Cursor;

use calamine::{Data, DataRef, ExcelDateTime, Reader, SheetType, SheetVisible, Xls, Xlsx};
use wholestring_contain::contain;

use crate::cells::limits::{self, Budget, too_much};
use crate::cells::shown::{self, Shown};
use crate::cells::table::{Cell, Position, Row};
use crate::error::{TableErrorKind, letters};
use crate::{cells::archive, cells::compound, cells::records};

/// The sheets of a workbook that are read.
#[derive(Debug)]
pub(crate) struct Workbook {
    pub(crate) sheets: Vec<Sheet>,
    /// Names of hidden sheets, which are not read.
    pub(crate) hidden: Vec<String>,
}

/// A sheet with its rows, including empty ones above the last and without hidden ones.
#[derive(Debug)]
pub(crate) struct Sheet {
    pub(crate) name: String,
    pub(crate) rows: Vec<Row>,
    /// Notes on contents that are not read.
    pub(crate) notes: Vec<String>,
    /// Those of the notes that concern hidden contents.
    pub(crate) hidden: Vec<String>,
    /// Place of its first formula without a result.
    pub(crate) uncalculated: Option<String>,
}

/// Treatment of dates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dates {
    /// As `a date`, because no number of a survey or a tally is one.
    Named,
    /// In ISO 8601: `2024-03-17T04:00:02.500`.
    Written,
}

/// Whether the bytes begin as a workbook: a zip archive or a compound file.
pub(crate) fn is_workbook(bytes: &[u8]) -> bool {
    // Signatures of a zip archive with parts, without any, or split over several files.
    let is_zip =
        [b"PK\x03\x04", b"PK\x05\x06", b"PK\x07\x08"].iter().any(|mark| bytes.starts_with(*mark));
    is_zip || bytes.starts_with(compound::MARK)
}

/// Reads the visible sheets of a workbook.
pub(crate) fn read(bytes: &[u8], dates: Dates) -> Result<Workbook, TableErrorKind> {
    if bytes.is_empty() {
        return Err(TableErrorKind::Empty);
    }
    // A folder in a browser contains texts, and a page should be small: readers of workbooks would
    // be a third of it.
    if cfg!(all(target_family = "wasm", target_os = "unknown")) {
        return Err(unreadable("in a browser alone none can: save its sheet as CSV"));
    }
    if !is_workbook(bytes) {
        return Err(unreadable("it does not begin as one"));
    }
    // The reader of workbooks is a third-party library that a damaged file may make panic.
    let read =
        contain(|| if bytes.starts_with(b"PK") { xlsx(bytes, dates) } else { xls(bytes, dates) });
    read.unwrap_or_else(|_| Err(damaged(())))
}

/// Note on hidden sheets.
pub(crate) fn hidden_sheets(names: &[String]) -> Option<String> {
    const LISTED: usize = 5;
    let mut listed: Vec<String> =
        names.iter().take(LISTED).map(|name| format!("'{name}'")).collect();
    if names.len() > LISTED {
        listed.push(format!("{} more", names.len() - LISTED));
    }
    match names {
        [] => None,
        [_] => Some(format!("the sheet {} is hidden and not read", listed.concat())),
        _ => Some(format!("the sheets {} are hidden and not read", listed.join(", "))),
    }
}

fn unreadable(reason: &str) -> TableErrorKind {
    TableErrorKind::NotAWorkbook { reason: reason.to_owned() }
}

/// The error of a file in which the library found a fault; its words mean nothing to a reader.
fn damaged<E>(_: E) -> TableErrorKind {
    unreadable("it is damaged")
}

/// The sign at the end of an archive, which a file that was cut off lacks.
const END: &[u8] = b"PK\x05\x06";

fn xlsx(bytes: &[u8], dates: Dates) -> Result<Workbook, TableErrorKind> {
    let parts = archive::check(bytes)?;
    if !bytes.windows(END.len()).any(|four| four == END) {
        return Err(unreadable("it is cut off"));
    }
    let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(damaged)?;
    let Worksheets { visible, places, hidden } = worksheets(workbook.sheets_metadata())?;
    let views = shown::of_sheets(&parts, &places)?;
    drop(parts);
    let mut sheets = Vec::new();
    let mut budget = Budget::default();
    for (name, view) in visible.into_iter().zip(views) {
        // Cells are read one by one, because the range of a sheet extends to its farthest cell.
        let mut reader = workbook.worksheet_cells_reader(&name).map_err(damaged)?;
        let mut cells = BTreeMap::new();
        let mut far = Vec::new();
        while let Some(cell) = reader.next_cell().map_err(damaged)? {
            budget.cells(1)?;
            // Checked before copying, because many cells may refer to one long text.
            if let DataRef::SharedString(text) = cell.get_value() {
                budget.text(text.len())?;
            }
            let (row, column) = cell.get_position();
            if is_far(row, column) {
                // One such cell suffices for the note.
                if far.is_empty() && !matches!(cell.get_value(), DataRef::Empty) {
                    far.push(far_note(row, column));
                }
                continue;
            }
            let value = Data::from(cell.get_value().clone());
            if let Some(cell) = self::cell(&value, row, column, dates) {
                cells.insert((row, column), cell);
            }
        }
        sheets.push(sheet(name, cells, &view, far, &mut budget)?);
    }
    Ok(Workbook { sheets, hidden })
}

fn xls(bytes: &[u8], dates: Dates) -> Result<Workbook, TableErrorKind> {
    let mut stream = compound::workbook_stream(bytes)?;
    let mut views: Vec<Shown> = records::check(&mut stream)?;
    let file = compound::file_of(&stream);
    drop(stream);
    let mut workbook = Xls::new(Cursor::new(file)).map_err(damaged)?;
    let Worksheets { visible, places, hidden } = worksheets(workbook.sheets_metadata())?;
    let mut sheets = Vec::new();
    let mut budget = Budget::default();
    for (name, place) in visible.into_iter().zip(places) {
        let range = workbook.worksheet_range(&name).map_err(damaged)?;
        let (top, left) = range.start().unwrap_or((0, 0));
        let cells = range
            .used_cells()
            .filter_map(|(row, column, data)| {
                let (row, column) = (top + row as u32, left + column as u32);
                Some(((row, column), cell(data, row, column, dates)?))
            })
            .collect();
        let view = views.get_mut(place).map(std::mem::take).unwrap_or_default();
        sheets.push(sheet(name, cells, &view, Vec::new(), &mut budget)?);
    }
    Ok(Workbook { sheets, hidden })
}

/// A sheet from its cells, without hidden ones.
fn sheet(
    name: String,
    mut cells: BTreeMap<(u32, u32), Cell>,
    view: &Shown,
    notes: Vec<String>,
    budget: &mut Budget,
) -> Result<Sheet, TableErrorKind> {
    for &(row, column) in view.uncalculated.iter().filter(|at| !is_far(at.0, at.1)) {
        let at = Position(row as usize, column as usize);
        let cell = Cell { is_uncalculated: true, ..Cell::new(String::new(), at) };
        cells.insert((row, column), cell);
    }
    let hidden: BTreeSet<(u32, u32)> =
        cells.keys().copied().filter(|at| view.is_hidden(at.0, at.1)).collect();
    cells.retain(|at, _| !hidden.contains(at));
    let first = cells.iter().find(|(_, cell)| cell.is_uncalculated);
    let uncalculated = first.map(|((row, column), _)| {
        format!(
            "cell {}{} of sheet '{name}' holds a formula that was never calculated",
            letters(column + 1),
            row + 1
        )
    });
    let hidden = view.notes(&name, &hidden);
    let rows = rows(cells, view, budget)?;
    Ok(Sheet { name, rows, notes, hidden, uncalculated })
}

/// The sheets that contain cells and not a chart.
struct Worksheets {
    visible: Vec<String>,
    /// Indices of the visible ones among all sheets.
    places: Vec<usize>,
    hidden: Vec<String>,
}

fn worksheets(sheets: &[calamine::Sheet]) -> Result<Worksheets, TableErrorKind> {
    if sheets.len() > limits::SHEETS {
        return Err(too_much(sheets.len(), "sheets", limits::SHEETS));
    }
    let mut found = Worksheets { visible: Vec::new(), places: Vec::new(), hidden: Vec::new() };
    for (place, sheet) in sheets.iter().enumerate() {
        match (sheet.typ, sheet.visible) {
            (SheetType::WorkSheet, SheetVisible::Visible) => {
                found.visible.push(sheet.name.clone());
                found.places.push(place);
            }
            (SheetType::WorkSheet, _) => found.hidden.push(sheet.name.clone()),
            _ => {}
        }
    }
    Ok(found)
}

/// Whether a cell is too far out to be read: a single one at the far corner would make a table of
/// the whole sheet. Old workbooks have no such cells.
fn is_far(row: u32, column: u32) -> bool {
    row as usize >= limits::ROWS || column >= limits::COLUMNS
}

/// Note on the first such cell.
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
fn cell(data: &Data, row: u32, column: u32, dates: Dates) -> Option<Cell> {
    let (text, number) = match data {
        Data::Empty => return None,
        Data::Float(number) => (number.to_string(), Some(*number)),
        Data::Int(number) => (number.to_string(), Some(*number as f64)),
        Data::String(text) | Data::DateTimeIso(text) | Data::DurationIso(text) => {
            (text.split_whitespace().collect::<Vec<_>>().join(" "), None)
        }
        Data::Bool(value) => (value.to_string(), None),
        Data::DateTime(date) if dates == Dates::Written => (date_text(date), None),
        Data::DateTime(_) => ("a date".to_owned(), None),
        Data::Error(error) => (error.to_string(), None),
    };
    let at = Position(row as usize, column as usize);
    (!text.is_empty()).then(|| Cell { number, ..Cell::new(text, at) })
}

/// A date, a time of day, or both, in ISO 8601.
fn date_text(date: &ExcelDateTime) -> String {
    let serial = date.as_f64();
    let (year, month, day, hour, minute, second, milli) = date.to_ymd_hms_milli();
    let time = match milli {
        0 => format!("{hour:02}:{minute:02}:{second:02}"),
        _ => format!("{hour:02}:{minute:02}:{second:02}.{milli:03}"),
    };
    let day = format!("{year:04}-{month:02}-{day:02}");
    match serial {
        _ if (0.0..1.0).contains(&serial) => time,
        _ if serial.fract() == 0.0 => day,
        _ => format!("{day}T{time}"),
    }
}

/// Arranges cells as rows without gaps; hidden rows and columns are left out.
fn rows(
    cells: BTreeMap<(u32, u32), Cell>,
    view: &Shown,
    budget: &mut Budget,
) -> Result<Vec<Row>, TableErrorKind> {
    // The columns in order, and one after the farthest as the place of a missing cell.
    let last = cells.keys().map(|(_, column)| column + 1).max().unwrap_or(0);
    let columns: Vec<usize> = (0..=last + view.hidden_columns.len() as u32)
        .filter(|column| !view.hidden_columns.contains(column))
        .map(|column| column as usize)
        .collect();
    let mut rows: Vec<Row> = Vec::new();
    let mut next = 0;
    for ((row, column), cell) in cells {
        while next <= row {
            if !view.hidden_rows.contains(&next) {
                rows.push(Row { cells: Vec::new(), end: Position(next as usize, columns[0]) });
            }
            next += 1;
        }
        let Some(row) = rows.last_mut() else { continue };
        let index = columns.partition_point(|other| *other < column as usize);
        budget.cells(index - row.cells.len())?;
        while row.cells.len() < index {
            let at = Position(row.end.0, columns[row.cells.len()]);
            row.cells.push(Cell::new(String::new(), at));
        }
        row.cells.push(cell);
        row.end.1 = columns[row.cells.len()];
    }
    Ok(rows)
}
