//! What is exported, to where.

use std::{
    fs,
    path::{Path, PathBuf},
    time::{SystemTime, UNIX_EPOCH},
};

use serde_json::Value as Json;
use wholestring_export::{Look, Version};
use wholestring_report::Workbook;
use wholestring_results::{ResultsError, ResultsFolder};
use wholestring_units::UnitSet;

use super::{logs, survey, tally, text, workbook};
use crate::{error::Error, page::PROGRAM, results_kinds::kind_of, survey::bytes};

/// A part of a case or of its results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// The tables of a folder of results; in WITSML hook load and torque against the depth of the bit.
    Results,
    /// The stations of the well.
    Survey,
    /// The components of the string, from the bit up.
    Tally,
}

/// How it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Text with commas, units in the headings.
    Csv,
    /// An Excel workbook.
    Xlsx,
    /// Columns of one width, as reports of surveys have them.
    Text,
    /// WITSML 1.4.1.1.
    Witsml1411,
    /// WITSML 2.0.
    Witsml20,
}

impl Format {
    /// The ending of its files.
    fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Xlsx => "xlsx",
            Self::Text => "txt",
            Self::Witsml1411 | Self::Witsml20 => "xml",
        }
    }

    fn version(self) -> Option<Version> {
        match self {
            Self::Witsml1411 => Some(Version::V1411),
            Self::Witsml20 => Some(Version::V20),
            Self::Csv | Self::Xlsx | Self::Text => None,
        }
    }
}

/// A request to export.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// A folder of results, or a case file.
    pub from: PathBuf,
    /// What of it; none for the results of a folder.
    pub what: Option<What>,
    /// How.
    pub format: Format,
    /// File, or folder for several; none beside what is exported.
    pub output: Option<PathBuf>,
    /// Units; none for the case's.
    pub units: Option<UnitSet>,
}

/// What was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// Files, in their order.
    pub files: Vec<PathBuf>,
    /// What is to be said of them, in sentences.
    pub notes: Vec<String>,
}

/// What is exported from: a name, and the settings with all defaults filled in.
pub(super) struct Source {
    pub(super) name: String,
    pub(super) settings: Json,
    /// The folder of results; none of a case file.
    pub(super) folder: Option<PathBuf>,
}

/// Writes what is requested.
///
/// # Errors
/// A folder or file that does not hold it, a format that has no place for it, a file that cannot be
/// written.
pub fn export(request: &Request) -> Result<Exported, Error> {
    let is_folder = request.from.is_dir();
    let what = match request.what {
        Some(what) => what,
        None if is_folder => What::Results,
        None => {
            return Err(Error::bad_input(format!(
                "{} is a case, which has a survey and a string; say which of them: --what survey or --what \
                 tally",
                request.from.display()
            )));
        }
    };
    let source = match is_folder {
        true => of_folder(&request.from, what)?,
        false => of_case(&request.from)?,
    };
    let units = request.units.unwrap_or_else(|| {
        source.settings["units"].as_str().and_then(|units| units.parse().ok()).unwrap_or_default()
    });
    let look = Look {
        name: source.name.clone(),
        created: timestamp(SystemTime::now()),
        program: PROGRAM.to_owned(),
        units,
    };
    let mut notes = Vec::new();
    let made = match what {
        What::Results => results(&source, &look, request.format, &mut notes)?,
        What::Survey => survey::export(&source, &look, request.format, &mut notes)?,
        What::Tally => tally::export(&source, &look, request.format, &mut notes)?,
    };
    let files = made.write(request, what)?;
    Ok(Exported { files, notes })
}

/// What was made, before it is written.
pub(super) enum Made {
    /// One file.
    File(Vec<u8>),
    /// Several, by the stems of their names.
    Files(Vec<(String, Vec<u8>)>),
}

impl Made {
    fn write(self, request: &Request, what: What) -> Result<Vec<PathBuf>, Error> {
        let ending = request.format.ending();
        let stem = match what {
            What::Results => "results",
            What::Survey => "survey",
            What::Tally => "tally",
        };
        match self {
            Self::File(content) => {
                let path = request.output.clone().unwrap_or_else(|| {
                    let name = format!("{stem}.{ending}");
                    match request.from.is_dir() {
                        true => request.from.join(name),
                        false => beside(&request.from, &name),
                    }
                });
                fs::write(&path, content)
                    .map_err(|source| ResultsError::Write { path: path.clone(), source })?;
                Ok(vec![path])
            }
            Self::Files(files) => {
                let folder = request.output.clone().unwrap_or_else(|| request.from.join("export"));
                let folder = ResultsFolder::create(folder)?;
                files
                    .into_iter()
                    .map(|(stem, content)| {
                        let name = format!("{stem}.{ending}");
                        folder.write_file(&name, &content)?;
                        Ok(folder.path().join(name))
                    })
                    .collect()
            }
        }
    }
}

/// `CASE-survey.csv` beside `CASE.toml`.
fn beside(case: &Path, name: &str) -> PathBuf {
    let stem = case.file_stem().unwrap_or_default().to_string_lossy();
    case.with_file_name(format!("{stem}-{name}"))
}

/// Results by the format that is requested.
fn results(
    source: &Source,
    look: &Look,
    format: Format,
    notes: &mut Vec<String>,
) -> Result<Made, Error> {
    let Some(folder) = &source.folder else {
        return Err(Error::bad_input(
            "a case file has no results: name the folder that a run, a plan or a sweep left",
        ));
    };
    if let Some(version) = format.version() {
        let logs = logs::of_folder(folder, notes)?;
        let text = wholestring_export::logs(look, &logs, version).map_err(Error::failed)?;
        return Ok(Made::File(text.into_bytes()));
    }
    match format {
        Format::Csv => {
            let workbook = workbook::of_folder(folder, look.units, notes)?;
            let sheets = workbook.sheets.iter();
            let files = sheets.map(|sheet| (file_stem(&sheet.name), text::csv(sheet).into_bytes()));
            Ok(Made::Files(files.collect()))
        }
        Format::Xlsx => {
            let workbook = workbook::of_folder(folder, look.units, notes)?;
            Ok(Made::File(workbook.bytes().map_err(Error::failed)?))
        }
        _ => Err(Error::bad_input(
            "results are not exported as a text report: expected csv, xlsx, witsml or witsml2",
        )),
    }
}

/// The name of a sheet as that of a file.
fn file_stem(name: &str) -> String {
    name.to_lowercase().replace(' ', "_")
}

/// One table, as CSV or as a workbook.
pub(super) fn one_table(
    table: &wholestring_results::Table,
    name: &str,
    about: &str,
    look: &Look,
    format: Format,
) -> Result<Made, Error> {
    let sheet = crate::sheet::sheet(name, table, about, look.units);
    if format == Format::Csv {
        return Ok(Made::File(text::csv(&sheet).into_bytes()));
    }
    let workbook = Workbook {
        title: look.name.clone(),
        about: Vec::new(),
        charts: Vec::new(),
        sheets: vec![sheet],
    };
    Ok(Made::File(workbook.bytes().map_err(Error::failed)?))
}

/// A folder of results.
fn of_folder(folder: &Path, what: What) -> Result<Source, Error> {
    let kind = kind_of(folder)?;
    let path = folder.join("summary.json");
    let folder = Some(folder.to_owned());
    if !path.is_file() {
        if what == What::Results {
            return Ok(Source { name: "Sweep".to_owned(), settings: Json::Null, folder });
        }
        return Err(Error::bad_input(format!(
            "{} holds {}, whose cases may differ: name the folder of one of them, or the case file",
            path.parent().unwrap_or(&path).display(),
            kind.noun
        )));
    }
    let bytes = bytes(&path, "summary")?;
    let mut summary: Json = serde_json::from_slice(&bytes).map_err(|error| {
        Error::bad_input(format!("{} is not a file of results: {error}", path.display()))
    })?;
    let settings = summary["settings"].take();
    let name = summary["case"].as_str().unwrap_or("Case").to_owned();
    Ok(Source { name, settings, folder })
}

/// A case file.
fn of_case(file: &Path) -> Result<Source, Error> {
    let case = wholestring_case::load(file, &[])?;
    Ok(Source { name: case.name, settings: case.settings, folder: None })
}

/// A time as XML writes it, to the second.
pub(super) fn timestamp(time: SystemTime) -> String {
    let seconds = time.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    let (days, of_day) = (seconds / 86_400, seconds % 86_400);
    // Days since the first of March of the year 0, of which every fourth year but three of each four
    // centuries ends with a day more.
    let shifted = days + 719_468;
    let (era, of_era) = (shifted / 146_097, shifted % 146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let from_march = (5 * of_year + 2) / 153;
    let day = of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    let year = year + era * 400 + u64::from(month <= 2);
    format!(
        "{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}Z",
        of_day / 3600,
        of_day / 60 % 60,
        of_day % 60
    )
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn times_are_written_as_xml_writes_them() {
        for (seconds, expected) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_164_799, "2024-02-28T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(timestamp(UNIX_EPOCH + Duration::from_secs(seconds)), expected);
        }
    }
}
