//! A log in a sheet of a workbook, as recorders export them: read as text between tabs, of which each
//! line is a row of the sheet.

use wholestring_tabular::SheetText;

use super::{
    contents::contents_of,
    csv,
    kind::Kind,
    log::Log,
    read::{read_log, unasked},
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::{Contents, Fragment, Note},
    input::Input,
};

/// Rows in which headings are looked for.
const AHEAD: usize = 60;

/// The sheets that are logs.
pub(crate) fn logs(sheets: &[SheetText]) -> Vec<&SheetText> {
    let is_log = |sheet: &&SheetText| csv::is_log(&text(sheet, AHEAD));
    sheets.iter().filter(is_log).collect()
}

/// The one that is meant of several: the only one, or the one that is picked.
pub(crate) fn picked<'a>(
    logs: &[&'a SheetText],
    name: &str,
    choices: &Choices,
) -> Result<Option<&'a SheetText>, ImportError> {
    let [_, _, ..] = logs else { return Ok(logs.first().copied()) };
    let what = "log".to_owned();
    let names = logs.iter().map(|sheet| sheet.name.clone()).collect();
    let kind = match choices.picked("log") {
        None => ImportErrorKind::Ambiguous { what, names },
        Some(picked) => match logs.iter().find(|sheet| sheet.name == picked) {
            Some(sheet) => return Ok(Some(sheet)),
            None => ImportErrorKind::NoSuch { what, name: picked.to_owned(), names },
        },
    };
    Err(ImportError::new(name, None, kind))
}

/// Picks weights and torques of a log.
pub(crate) fn read(
    sheet: &SheetText,
    name: &str,
    choices: &Choices,
) -> Result<Fragment, ImportError> {
    let text = text(sheet, usize::MAX);
    let mut log = opened(sheet, name, &text, choices).map_err(|error| in_sheet(error, sheet))?;
    let read = log.ask().and_then(|()| read_log(log, name, choices));
    read.map_err(|error| in_sheet(error, sheet))
}

/// What a log holds.
pub(crate) fn contents(sheet: &SheetText, name: &str) -> Result<Contents, ImportError> {
    let text = text(sheet, usize::MAX);
    let opened = opened(sheet, name, &text, &Choices::default());
    opened.and_then(contents_of).map_err(|error| in_sheet(error, sheet))
}

fn opened<'a>(
    sheet: &SheetText,
    name: &str,
    text: &'a [u8],
    choices: &Choices,
) -> Result<Log<'a>, ImportError> {
    let mut log = unasked(Input::of_bytes(name, text), Kind::Csv, choices)?;
    log.what = format!("a log of a rig in sheet '{}'", sheet.name);
    log.notes.push(Note::Read(format!("lines are the rows of sheet '{}'", sheet.name)));
    log.notes.extend(sheet.notes.iter().cloned().map(Note::LeftOut));
    Ok(log)
}

/// The error with its place in the sheet.
fn in_sheet(error: ImportError, sheet: &SheetText) -> ImportError {
    let line = error.place().and_then(|place| place.strip_prefix("line "));
    let Some(line) = line else { return error };
    let place = format!("sheet '{}', row {line}", sheet.name);
    ImportError::new(error.file(), Some(place), error.kind().clone())
}

/// The first rows of a sheet as lines of cells between tabs, which no cell holds.
fn text(sheet: &SheetText, rows: usize) -> Vec<u8> {
    let mut text = Vec::new();
    for row in sheet.rows.iter().take(rows) {
        for (at, cell) in row.iter().enumerate() {
            if at > 0 {
                text.push(b'\t');
            }
            // A quotation mark would hold cells together.
            text.extend(cell.replace('"', "''").into_bytes());
        }
        text.push(b'\n');
    }
    text
}
