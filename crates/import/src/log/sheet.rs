//! A log in a sheet of a workbook, as recorders export them: read as tab-separated text with one
//! line per row of the sheet.

use wholestring_tabular::{SheetText, UNCALCULATED};

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

/// Number of rows searched for headings.
const AHEAD: usize = 60;

/// Returns the sheets that are logs.
pub(crate) fn logs(sheets: &[SheetText]) -> Vec<&SheetText> {
    let is_log = |sheet: &&SheetText| csv::is_log(&text(sheet, AHEAD));
    sheets.iter().filter(is_log).collect()
}

/// Returns the sheet to read: the only log, or the picked one.
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

/// Picks weights and torques from a log.
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

/// Describes the contents of a log.
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

/// Adds to an error the place in the sheet, and what of the sheet was not read where that may be
/// the reason.
fn in_sheet(error: ImportError, sheet: &SheetText) -> ImportError {
    let kind = match error.kind() {
        ImportErrorKind::NotANumber { what, found } if found == UNCALCULATED => {
            ImportErrorKind::Refused(format!(
                "the {what} is a formula whose result was never calculated; open the workbook in \
                 Excel or LibreOffice and save it"
            ))
        }
        kind @ (ImportErrorKind::Missing { .. } | ImportErrorKind::Refused(_))
            if error.place().is_none() && !sheet.notes.is_empty() =>
        {
            ImportErrorKind::Refused(format!("{kind} ({})", sheet.notes.join("; ")))
        }
        kind => kind.clone(),
    };
    let line = error.place().and_then(|place| place.strip_prefix("line "));
    let place = match line {
        Some(line) => Some(format!("sheet '{}', row {line}", sheet.name)),
        None => error.place().map(str::to_owned),
    };
    ImportError::new(error.file(), place, kind)
}

/// Returns the first rows of a sheet as lines of tab-separated cells; no cell contains a tab.
fn text(sheet: &SheetText, rows: usize) -> Vec<u8> {
    let mut text = Vec::new();
    for row in sheet.rows.iter().take(rows) {
        for (at, cell) in row.iter().enumerate() {
            if at > 0 {
                text.push(b'\t');
            }
            // A quotation mark would join cells.
            text.extend(cell.replace('"', "''").into_bytes());
        }
        text.push(b'\n');
    }
    text
}
