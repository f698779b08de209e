//! Converts bytes to a survey: the first table with the needed columns is read.

use crate::{
    cells::{
        self,
        table::{Source, Table},
    },
    columns::{
        header::{self, Headed, Header, headed},
        layout,
        names::{READINGS, SURVEY},
    },
    error::{TableError, TableErrorKind},
    readings::{self, ImportedReadings},
    survey::{
        imported::{ImportedSurvey, SurveyTable},
        said::Said,
        stations,
        tables::{each, told_apart},
    },
};

/// Reads a survey: as a workbook if its content or its name is that of one, otherwise as text.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists, with its place.
pub fn read(bytes: &[u8], name: &str) -> Result<ImportedSurvey, TableError> {
    read_as(bytes, name, &Said::default())
}

/// Reads a survey as [`read`] does, with information that its file may lack.
///
/// ```
/// use wholestring_tabular::{Said, read, read_as};
///
/// let bare = b"0 0 0\n1000 0 0\n";
/// assert!(read(bare, "a.txt").is_err());
/// let foot = wholestring_units::Dimension::Length.find_unit("ft");
/// let said = Said { length_unit: foot, ..Said::default() };
/// assert_eq!(read_as(bare, "a.txt", &said)?.stations[1].md_m, 304.8);
/// # Ok::<(), wholestring_tabular::TableError>(())
/// ```
///
/// # Errors
/// As [`read`].
pub fn read_as(bytes: &[u8], name: &str, said: &Said) -> Result<ImportedSurvey, TableError> {
    first(read_all(bytes, name, said)?, name)
}

/// Reads every survey of a file: on each sheet of a workbook, and one below the other.
///
/// # Errors
/// A file without any survey, or one that cannot be read at all. A table with the columns of a
/// survey that is invalid contains its own error.
pub fn read_all(bytes: &[u8], name: &str, said: &Said) -> Result<Vec<SurveyTable>, TableError> {
    match cells::is_workbook(bytes, name) {
        true => excel(bytes, name, said),
        false => csv(bytes, name, said),
    }
}

/// Returns the survey of the first sheet that has one, or of a text. Two surveys in one text are
/// ambiguous.
fn first(mut tables: Vec<SurveyTable>, name: &str) -> Result<ImportedSurvey, TableError> {
    let sheet = tables.first().and_then(|table| table.sheet.clone());
    let (same, others): (Vec<_>, Vec<_>) = tables.drain(..).partition(|table| table.sheet == sheet);
    if same.len() > 1 {
        let surveys = same.into_iter().map(|table| table.name).collect();
        return Err(TableError::new(name, TableErrorKind::SeveralSurveys { surveys }, None, None));
    }
    let nothing = || Err(TableError::new(name, TableErrorKind::NoHeader, None, None));
    let mut survey = same.into_iter().next().map_or_else(nothing, |table| table.survey)?;
    let others = others.into_iter().filter_map(|other| other.survey.ok());
    survey.notes.extend(others.map(|other| format!("a survey in {} is not read", other.place)));
    Ok(survey)
}

/// Reads weights and torques at the surface against bit depth, from the same formats as a survey: a
/// header names the columns and their units, `Bit depth (m)`, `Pick-up (kN)`, `Slack-off (kN)`,
/// `Rotating (kN)`, `Torque (kN.m)`, `Torque on bottom (kN.m)`; optional columns are `Mud (sg)`,
/// and `Case` if there are several.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists, with its place.
pub fn read_readings(bytes: &[u8], name: &str) -> Result<ImportedReadings, TableError> {
    let first = |tables: &[Table], unread: &str| {
        read_readings_of(tables).unwrap_or_else(|| {
            let kind = TableErrorKind::NoReadings { found: "no header names them" };
            Err(TableError::new(name, kind, None, None).with_unread(unread))
        })
    };
    let found = match cells::is_workbook(bytes, name) {
        true => cells::of_workbook(bytes, name, |tables, book| first(tables, &book.unread)),
        false => cells::of_text(bytes, name, |tables, _| first(tables, "")),
    };
    found.map_err(|error| error.of_readings())?
}

fn read_readings_of(tables: &[Table]) -> Option<Result<ImportedReadings, TableError>> {
    match headed(tables, &READINGS) {
        Headed::Found(table, header) => {
            let mut readings = readings_below(table, header);
            if let Ok(readings) = &mut readings {
                readings.notes.extend(other_readings(tables, table));
            }
            Some(readings)
        }
        Headed::Nearest(partial, table) if partial.is_header() => {
            Some(Err(partial.error(table, &READINGS)))
        }
        Headed::Nearest(..) | Headed::None => None,
    }
}

fn readings_below(table: &Table, header: Header) -> Result<ImportedReadings, TableError> {
    let layout = layout::below(table, header, &Said::default());
    layout.and_then(|layout| readings::read(table, layout))
}

/// Notes on the readings in other sheets of a workbook than the one that is read.
fn other_readings(tables: &[Table], own: &Table) -> Vec<String> {
    let Source::Sheet { sheet: own, .. } = own.source else { return Vec::new() };
    let notes = tables.iter().filter_map(|table| {
        let Source::Sheet { sheet, .. } = table.source else { return None };
        let header = header::find(table, &READINGS).ok().filter(|_| sheet != own)?;
        let count = readings_below(table, header).ok()?.readings.len();
        let rows = if count == 1 { "row" } else { "rows" };
        Some(format!("readings in sheet '{sheet}' ({count} {rows}) are not read"))
    });
    notes.collect()
}

/// Reads a survey from text: CSV with any separator, or a report in columns.
///
/// `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists except errors of workbooks, with its place.
pub fn read_csv(bytes: &[u8], name: &str) -> Result<ImportedSurvey, TableError> {
    first(csv(bytes, name, &Said::default())?, name)
}

fn csv(bytes: &[u8], name: &str, said: &Said) -> Result<Vec<SurveyTable>, TableError> {
    cells::of_text(bytes, name, |tables, source| {
        // They are cut from one text: the first one with a header is used.
        let headed = tables.iter().position(|table| header::find(table, &SURVEY).is_ok());
        let tables = headed.map_or(tables, |at| &tables[at..=at]);
        surveys(tables, said).unwrap_or_else(|| Err(source.error(TableErrorKind::NoHeader, None)))
    })?
}

/// Reads a survey from the bytes of an Excel workbook, `.xlsx` or `.xls`.
///
/// The first sheet with the needed columns is read. `name` is the file's, for messages.
///
/// # Errors
/// Everything that [`TableErrorKind`] lists except errors of text, with its place.
pub fn read_excel(bytes: &[u8], name: &str) -> Result<ImportedSurvey, TableError> {
    first(excel(bytes, name, &Said::default())?, name)
}

fn excel(bytes: &[u8], name: &str, said: &Said) -> Result<Vec<SurveyTable>, TableError> {
    cells::of_workbook(bytes, name, |tables, book| {
        surveys(tables, said).unwrap_or_else(|| {
            let kind = TableErrorKind::NoSurveySheet { sheets: book.names.clone() };
            Err(TableError::new(name, kind, None, None).with_unread(&book.unread))
        })
    })?
}

/// Returns the tables with a header that names the needed columns; otherwise the first one of three
/// bare columns; otherwise the error of the header that resembles one most. `None` if there is no
/// similar header.
fn surveys(tables: &[Table], said: &Said) -> Option<Result<Vec<SurveyTable>, TableError>> {
    let mut found = Vec::new();
    for table in tables {
        if let Ok(header) = header::find(table, &SURVEY) {
            found.extend(each(table, header, said));
        }
    }
    if !found.is_empty() {
        // An empty form.
        let is_empty = |table: &SurveyTable| {
            let kind = table.survey.as_ref().err().map(TableError::kind);
            matches!(kind, Some(TableErrorKind::TooFewStations { found: 0 }))
        };
        if !found.iter().all(is_empty) {
            found.retain(|table| !is_empty(table));
        }
        return Some(Ok(told_apart(found)));
    }
    let nearest = match headed(tables, &SURVEY) {
        Headed::Nearest(partial, table) => Some((partial, table)),
        Headed::Found(..) | Headed::None => None,
    };
    // Two named columns are a header; one may be a word of a title.
    if nearest.as_ref().is_none_or(|(partial, _)| partial.count < 2) {
        let bare =
            tables.iter().find_map(|table| Some((table, layout::without_header(table, said)?)));
        if let Some((table, layout)) = bare {
            let survey = layout.map_err(stations::Broken::from);
            let survey = survey.and_then(|layout| stations::read(table, &layout));
            return Some(
                survey.map_err(|broken| broken.error).map(|survey| vec![bare_table(survey)]),
            );
        }
    }
    let (partial, table) = nearest.filter(|(partial, _)| partial.is_header())?;
    Some(Err(partial.error(table, &SURVEY)))
}

/// A table of three columns without names.
fn bare_table(survey: ImportedSurvey) -> SurveyTable {
    SurveyTable { name: survey.place.clone(), sheet: None, survey: Ok(survey) }
}
