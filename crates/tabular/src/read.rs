//! From bytes to a survey: the first table with the needed columns is read.

use crate::{
    cells::{self, table::Table},
    columns::{
        header::{Headed, headed},
        layout,
        sort::{READINGS, SURVEY},
    },
    error::{TableError, TableErrorKind},
    readings::{self, ImportedReadings},
    survey::{imported::ImportedSurvey, said::Said, stations},
};

/// Reads a survey: a workbook if its content or its name says so, text otherwise.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists, with its place.
pub fn read(bytes: &[u8], name: &str) -> Result<ImportedSurvey, TableError> {
    read_as(bytes, name, &Said::default())
}

/// Reads a survey as [`read`] does, of which something is said that its file may not tell.
///
/// ```
/// use wholestring_tabular::{Said, read, read_as};
///
/// let bare = b"0 0 0\n1000 0 0\n";
/// assert!(read(bare, "a.txt").is_err());
/// let said = Said { length_unit: wholestring_units::Dimension::Length.find_unit("ft") };
/// assert_eq!(read_as(bare, "a.txt", &said)?.stations[1].md_m, 304.8);
/// # Ok::<(), wholestring_tabular::TableError>(())
/// ```
///
/// # Errors
/// As [`read`].
pub fn read_as(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, TableError> {
    match cells::is_workbook(bytes, name) {
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
/// Everything that [`TableErrorKind`] lists, with its place.
pub fn read_readings(bytes: &[u8], name: &str) -> Result<ImportedReadings, TableError> {
    let first = |tables: &[Table]| read_readings_of(tables);
    let found = match cells::is_workbook(bytes, name) {
        true => cells::of_workbook(bytes, name, |tables, _| first(tables)),
        false => cells::of_text(bytes, name, |tables, _| first(tables)),
    };
    found.map_err(|error| error.of_readings())?.ok_or_else(|| {
        TableError::new(
            name,
            TableErrorKind::NoReadings { found: "no header names them" },
            None,
            None,
        )
    })?
}

fn read_readings_of(tables: &[Table]) -> Option<Result<ImportedReadings, TableError>> {
    match headed(tables, &READINGS) {
        Headed::Found(table, header) => {
            let layout = layout::below(table, header, &Said::default());
            Some(layout.and_then(|layout| readings::read(table, layout)))
        }
        Headed::Nearest(partial, table) if partial.is_header() => Some(Err(partial.error(table))),
        Headed::Nearest(..) | Headed::None => None,
    }
}

/// Reads a survey from text: CSV with any sign between its cells, or a report in columns.
///
/// `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists but what concerns workbooks, with its place.
pub fn read_csv(bytes: &[u8], name: &str) -> Result<ImportedSurvey, TableError> {
    csv(bytes, name, &Said::default())
}

fn csv(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, TableError> {
    cells::of_text(bytes, name, |tables, source| {
        read_first(tables, said)
            .unwrap_or_else(|| Err(source.error(TableErrorKind::NoHeader, None)))
    })?
}

/// Reads a survey from the bytes of an Excel workbook, `.xlsx` or `.xls`.
///
/// The first sheet with the needed columns is read. `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists but what concerns text, with its place.
pub fn read_excel(bytes: &[u8], name: &str) -> Result<ImportedSurvey, TableError> {
    excel(bytes, name, &Said::default())
}

fn excel(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, TableError> {
    cells::of_workbook(bytes, name, |tables, names| {
        read_first(tables, said).unwrap_or_else(|| {
            let kind = TableErrorKind::NoSurveySheet { sheets: names.to_vec() };
            Err(TableError::new(name, kind, None, None))
        })
    })?
}

/// The first of the tables with a header that names the needed columns; or else the first of three
/// bare columns; or else the error of the header that comes nearest. `None` if none comes near.
fn read_first(tables: &[Table], said: &Said) -> Option<Result<ImportedSurvey, TableError>> {
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
