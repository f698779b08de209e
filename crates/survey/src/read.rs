//! From bytes to a survey: the first table with the needed columns is read.

use crate::{
    blanks, decode, delimited,
    error::{SurveyError, SurveyErrorKind},
    header,
    imported::ImportedSurvey,
    layout, limits,
    readings::{self, ImportedReadings},
    said::Said,
    sort::{READINGS, SURVEY, Sort},
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
    match is_workbook(bytes, name) {
        true => excel(bytes, name, said),
        false => csv(bytes, name, said),
    }
}

/// Reads weights and torques at the surface against the depth of the bit, from whatever a survey is
/// read from: a header names the columns and their units, `Bit depth (m)`, `Pick-up (kN)`,
/// `Slack-off (kN)`, `Rotating (kN)`, `Torque (kN.m)`, `Torque on bottom (kN.m)`; beside them
/// `Mud (sg)`, and `Case` where there are several.
///
/// # Errors
/// Everything that [`SurveyErrorKind`] lists, with its place.
pub fn read_readings(bytes: &[u8], name: &str) -> Result<ImportedReadings, SurveyError> {
    let first = |tables: &[Table]| read_readings_of(tables);
    let found = match is_workbook(bytes, name) {
        true => sheets_of(bytes, name, |tables, _| first(tables)),
        false => tables_of(bytes, name, |tables, _| first(tables)),
    };
    found.map_err(|error| error.of_readings())?.ok_or_else(|| {
        SurveyError::new(
            name,
            SurveyErrorKind::NoReadings { found: "no header names them" },
            None,
            None,
        )
    })?
}

fn read_readings_of(tables: &[Table]) -> Option<Result<ImportedReadings, SurveyError>> {
    match headed(tables, &READINGS) {
        Headed::Found(table, header) => {
            let layout = layout::below(table, header, &Said::default());
            Some(layout.and_then(|layout| readings::read(table, layout)))
        }
        Headed::Nearest(partial, table) if partial.is_header() => Some(Err(partial.error(table))),
        Headed::Nearest(..) | Headed::None => None,
    }
}

/// A text under the name .xls is common; a workbook by its content is one under any name.
fn is_workbook(bytes: &[u8], name: &str) -> bool {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    let named_so = ["xlsx", "xlsm", "xlsb", "ods"]
        .iter()
        .any(|workbook| extension.eq_ignore_ascii_case(workbook));
    workbook::is_workbook(bytes) || (named_so && !bytes.is_empty())
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
    tables_of(bytes, name, |tables, source| {
        read_first(tables, said)
            .unwrap_or_else(|| Err(source.error(SurveyErrorKind::NoHeader, None)))
    })?
}

/// What is made of the tables of a text, cut at each sign that may part its cells.
fn tables_of<R>(
    bytes: &[u8],
    name: &str,
    of: impl FnOnce(&[Table], Source) -> R,
) -> Result<R, SurveyError> {
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
    Ok(of(&tables, source))
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
    sheets_of(bytes, name, |tables, names| {
        read_first(tables, said).unwrap_or_else(|| {
            let kind = SurveyErrorKind::NoSurveySheet { sheets: names.to_vec() };
            Err(SurveyError::new(name, kind, None, None))
        })
    })?
}

/// What is made of the sheets of a workbook, and their names.
fn sheets_of<R>(
    bytes: &[u8],
    name: &str,
    of: impl FnOnce(&[Table], &[String]) -> R,
) -> Result<R, SurveyError> {
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
    Ok(of(&tables, &names))
}

/// A header among tables.
enum Headed<'a> {
    Found(&'a Table<'a>, header::Header),
    /// The one that comes nearest.
    Nearest(header::Partial, &'a Table<'a>),
    None,
}

/// The first of the tables with a header that names the needed columns.
fn headed<'a>(tables: &'a [Table<'a>], sort: &Sort) -> Headed<'a> {
    let mut nearest: Option<(header::Partial, &Table)> = None;
    for table in tables {
        match header::find(table, sort) {
            Ok(header) => return Headed::Found(table, header),
            Err(Some(partial)) => {
                let nearer = nearest.as_ref().is_none_or(|(best, _)| partial.count > best.count);
                if nearer {
                    nearest = Some((partial, table));
                }
            }
            Err(None) => {}
        }
    }
    nearest.map_or(Headed::None, |(partial, table)| Headed::Nearest(partial, table))
}

/// The first of the tables with a header that names the needed columns; or else the first of three
/// bare columns; or else the error of the header that comes nearest. `None` if none comes near.
fn read_first(tables: &[Table], said: &Said) -> Option<Result<ImportedSurvey, SurveyError>> {
    let nearest = match headed(tables, &SURVEY) {
        Headed::Found(table, header) => {
            let layout = layout::below(table, header, said);
            return Some(layout.and_then(|layout| stations::read(table, layout)));
        }
        Headed::Nearest(partial, table) => Some((partial, table)),
        Headed::None => None,
    };
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
