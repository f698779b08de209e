//! From the bytes of a file to its tables.

use super::{
    blanks, decode, delimited, limits,
    table::{Row, Source, Table},
    workbook,
};
use crate::error::{TableError, TableErrorKind};

/// Separators of cells, in the order in which they are tried.
const SIGNS: [(u8, &str); 3] = [(b'\t', "tabs"), (b';', "semicolons"), (b',', "commas")];

/// A text with the extension .xls is common; a file with a workbook's content is one under any
/// name.
pub(crate) fn is_workbook(bytes: &[u8], name: &str) -> bool {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let named_so = ["xlsx", "xlsm", "xlsb", "ods"]
        .iter()
        .any(|workbook| extension.eq_ignore_ascii_case(workbook));
    let is_text = || std::str::from_utf8(bytes).is_ok_and(|text| !text.contains('\0'));
    workbook::is_workbook(bytes) || (named_so && !bytes.is_empty() && !is_text())
}

/// Formats that programs save under the name of a table, by how they begin.
fn other_format(bytes: &[u8]) -> Option<&'static str> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let begins = |with: &str| {
        text.get(..with.len()).is_some_and(|head| head.eq_ignore_ascii_case(with.as_bytes()))
    };
    match () {
        () if begins("%PDF") => Some("a PDF document"),
        () if ["<!doctype html", "<html", "<table", "<meta"].into_iter().any(begins) => {
            Some("a web page (HTML)")
        }
        () if begins("{\\rtf") => Some("a document of a word processor (RTF)"),
        () => None,
    }
}

/// Applies a function to the tables of a text, cut at each possible separator.
pub(crate) fn of_text<R>(
    bytes: &[u8],
    name: &str,
    read: impl FnOnce(&[Table], Source) -> R,
) -> Result<R, TableError> {
    if let Some(what) = other_format(bytes) {
        return Err(TableError::new(name, TableErrorKind::OtherFormat { what }, None, None));
    }
    let Some(text) = decode::text(bytes) else {
        return Err(TableError::new(name, TableErrorKind::NotText, None, None));
    };
    let source = Source::Text { file: name, text: &text };
    if text.trim().is_empty() {
        return Err(source.error(TableErrorKind::Empty, None));
    }

    fits(&text).map_err(|kind| TableError::new(name, kind, None, None))?;
    let mut tables: Vec<Table> = SIGNS
        .iter()
        .filter(|(sign, _)| text.as_bytes().contains(sign))
        .map(|&(sign, parted_by)| delimited::cut(source, &text, sign, parted_by))
        .collect();
    tables.push(blanks::cut(source, &text));
    Ok(read(&tables, source))
}

/// Checks the number of rows and cells of a text against the limits, for any separator.
fn fits(text: &str) -> Result<(), TableErrorKind> {
    let count = |counts: &dyn Fn(u8) -> bool| text.bytes().filter(|byte| counts(*byte)).count();
    let rows = count(&|byte| matches!(byte, b'\n' | b'\r')) + 1;
    // Lines that end with two characters count twice.
    let rows = rows - text.matches("\r\n").count();
    if rows > limits::ROWS {
        return Err(limits::too_much(rows, "lines", limits::ROWS));
    }
    let blanks = text.split_whitespace().count();
    let cells =
        SIGNS.map(|(sign, _)| count(&|byte| byte == sign)).into_iter().fold(blanks, usize::max)
            + rows;
    if cells > limits::CELLS {
        return Err(limits::too_much(cells, "cells", limits::CELLS));
    }
    Ok(())
}

/// A workbook as a whole.
#[derive(Debug)]
pub(crate) struct Book {
    /// Names of its visible sheets.
    pub(crate) names: Vec<String>,
    /// Contents that are not read and might be missed, in words.
    pub(crate) unread: String,
}

/// Applies a function to the visible sheets of a workbook.
pub(crate) fn of_workbook<R>(
    bytes: &[u8],
    name: &str,
    read: impl FnOnce(&[Table], &Book) -> R,
) -> Result<R, TableError> {
    let workbook::Workbook { sheets, hidden } = workbook::read(bytes, workbook::Dates::Named)
        .map_err(|kind| TableError::new(name, kind, None, None))?;
    let hidden = workbook::hidden_sheets(&hidden);
    let unread: Vec<String> = sheets
        .iter()
        .map(|sheet| {
            let all = sheet.hidden.iter().chain(&sheet.uncalculated).chain(&hidden);
            all.map(String::as_str).collect::<Vec<_>>().join("; ")
        })
        .collect();
    let whole = sheets.iter().flat_map(|sheet| sheet.hidden.iter().chain(&sheet.uncalculated));
    let book = Book {
        names: sheets.iter().map(|sheet| sheet.name.clone()).collect(),
        unread: whole.chain(&hidden).map(String::as_str).collect::<Vec<_>>().join("; "),
    };
    let tables: Vec<Table> = sheets
        .into_iter()
        .zip(book.names.iter().zip(&unread))
        .map(|(workbook::Sheet { rows, notes, hidden: own, .. }, (sheet, unread))| Table {
            source: Source::Sheet { file: name, sheet, unread },
            rows,
            parted_by: None,
            counted: None,
            notes: notes.into_iter().chain(own).chain(hidden.clone()).collect(),
        })
        .collect();
    Ok(read(&tables, &book))
}

/// The part of a table above a row.
pub(crate) fn above<'a>(table: &Table<'a>, row: usize) -> Table<'a> {
    with_rows(table, &table.rows[..row.min(table.rows.len())])
}

/// The part of a table from a row on. Columns separated by blanks may have other positions there,
/// and are cut again.
pub(crate) fn below<'a>(table: &Table<'a>, row: usize) -> Table<'a> {
    match (table.source, row.checked_sub(1).and_then(|above| table.rows.get(above))) {
        (Source::Text { text, .. }, Some(above)) if table.counted.is_some() => {
            blanks::cut_from(table.source, text, above.end.0)
        }
        _ => with_rows(table, &table.rows[row.min(table.rows.len())..]),
    }
}

fn with_rows<'a>(table: &Table<'a>, rows: &[Row]) -> Table<'a> {
    let Table { source, parted_by, counted, ref notes, .. } = *table;
    Table { source, rows: rows.to_vec(), parted_by, counted, notes: notes.clone() }
}
