//! From bytes to a survey: the first table with the needed columns is read.

use crate::{
    blanks, decode, delimited,
    error::{SurveyError, SurveyErrorKind},
    header,
    imported::ImportedSurvey,
    layout, limits,
    said::Said,
    stations,
    table::{Source, Table},
    workbook,
};

/// The signs that part cells, in the order in which they are tried.
const SIGNS: [(u8, &str); 3] = [(b'\t', "tabs"), (b';', "semicolons"), (b',', "commas")];

/// Reads a survey: a workbook if its content or its name says so, text otherwise.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists, with its place.
pub fn read(bytes: &[u8], name: &str) -> Result<ImportedSurvey, SurveyError> {
    read_as(bytes, name, &Said::default())
}

/// Reads a survey as [`read`] does, of which something is said that its file may not tell.
///
/// ```
/// use wholestring_survey::{Said, read, read_as};
///
/// let bare = b"0 0 0\n1000 0 0\n";
/// assert!(read(bare, "a.txt").is_err());
/// let said = Said { length_unit: wholestring_units::Dimension::Length.find_unit("ft") };
/// assert_eq!(read_as(bare, "a.txt", &said)?.stations[1].md_m, 304.8);
/// # Ok::<(), wholestring_survey::SurveyError>(())
/// ```
///
/// # Errors
/// As [`read`].
pub fn read_as(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, SurveyError> {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let named_so = ["xlsx", "xlsm", "xlsb", "ods"]
        .iter()
        .any(|workbook| extension.eq_ignore_ascii_case(workbook));
    // A text under the name .xls is common; a workbook by its content is one under any name.
    if workbook::is_workbook(bytes) || (named_so && !bytes.is_empty()) {
        excel(bytes, name, said)
    } else {
        csv(bytes, name, said)
    }
}

/// Reads a survey from text: CSV with any sign between its cells, or a report in columns.
///
/// `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists but what concerns workbooks, with its place.
pub fn read_csv(bytes: &[u8], name: &str) -> Result<ImportedSurvey, SurveyError> {
    csv(bytes, name, &Said::default())
}

fn csv(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, SurveyError> {
    let Some(text) = decode::text(bytes) else {
        return Err(SurveyError::new(name, SurveyErrorKind::NotText, None, None));
    };
    let source = Source::Text { file: name, text: &text };
    if text.trim().is_empty() {
        return Err(source.error(SurveyErrorKind::Empty, None));
    }

    fits(&text).map_err(|kind| SurveyError::new(name, kind, None, None))?;
    let mut tables: Vec<Table> = SIGNS
        .iter()
        .filter(|(sign, _)| text.as_bytes().contains(sign))
        .map(|&(sign, parted_by)| delimited::cut(source, &text, sign, parted_by))
        .collect();
    tables.push(blanks::cut(source, &text));
    read_first(&tables, said).unwrap_or_else(|| Err(source.error(SurveyErrorKind::NoHeader, None)))
}

/// Whether a text has no more rows and cells than are read, by whatever sign it is cut.
fn fits(text: &str) -> Result<(), SurveyErrorKind> {
    let count = |of: &dyn Fn(u8) -> bool| text.bytes().filter(|byte| of(*byte)).count();
    let rows = count(&|byte| matches!(byte, b'\n' | b'\r')) + 1;
    // Lines that end with two signs count twice.
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

/// Reads a survey from the bytes of an Excel workbook, `.xlsx` or `.xls`.
///
/// The first sheet with the needed columns is read. `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists but what concerns text, with its place.
pub fn read_excel(bytes: &[u8], name: &str) -> Result<ImportedSurvey, SurveyError> {
    excel(bytes, name, &Said::default())
}

fn excel(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, SurveyError> {
    let sheets =
        workbook::sheets(bytes).map_err(|kind| SurveyError::new(name, kind, None, None))?;
    let (names, rows): (Vec<String>, Vec<_>) =
        sheets.into_iter().map(|sheet| (sheet.name, sheet.rows)).unzip();
    let tables: Vec<Table> = names
        .iter()
        .zip(rows)
        .map(|(sheet, rows)| Table {
            source: Source::Sheet { file: name, sheet },
            rows,
            parted_by: None,
            counted: None,
            notes: Vec::new(),
        })
        .collect();
    read_first(&tables, said).unwrap_or_else(|| {
        let sheets = names.clone();
        let kind = SurveyErrorKind::NoSurveySheet { sheets };
        Err(SurveyError::new(name, kind, None, None))
    })
}

/// The first of the tables with a header that names the needed columns; or else the first of three
/// bare columns; or else the error of the header that comes nearest. `None` if none comes near.
fn read_first(tables: &[Table], said: &Said) -> Option<Result<ImportedSurvey, SurveyError>> {
    let mut nearest: Option<(header::Partial, &Table)> = None;
    for table in tables {
        match header::find(table) {
            Ok(header) => {
                let layout = layout::below(table, header, said);
                return Some(layout.and_then(|layout| stations::read(table, layout)));
            }
            Err(Some(partial)) => {
                let nearer = nearest.as_ref().is_none_or(|(best, _)| partial.count > best.count);
                if nearer {
                    nearest = Some((partial, table));
                }
            }
            Err(None) => {}
        }
    }
    // Two columns named are a header; one may be a title's word.
    if nearest.as_ref().is_none_or(|(partial, _)| partial.count < 2) {
        let bare =
            tables.iter().find_map(|table| Some((table, layout::without_header(table, said)?)));
        if let Some((table, layout)) = bare {
            return Some(layout.and_then(|layout| stations::read(table, layout)));
        }
    }
    let (partial, table) = nearest.filter(|(partial, _)| partial.is_header())?;
    Some(Err(partial.error(table)))
}
