//! Results, the survey and the string of a case in the formats of other programs.

mod format;
mod logs;
mod source;
mod survey;
mod tally;
mod workbook;

pub use format::{Format, What};
pub use wholestring_export::Version as WitsmlVersion;

use std::{path::PathBuf, time::SystemTime};

use wholestring_export::Look;
use wholestring_units::UnitSet;

use self::{
    format::Made,
    source::{Source, of_case, of_folder, timestamp},
};
use crate::{error::Error, page::PROGRAM};

// Request of an export, and its outcome.

/// Request of an export.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// A folder of results, or a case file.
    pub from: PathBuf,
    /// Part to export; `None` for the results of a folder.
    pub what: Option<What>,
    /// Format.
    pub format: Format,
    /// File, or folder for several files; `None` to write next to the source.
    pub output: Option<PathBuf>,
    /// Units; `None` for those of the case.
    pub units: Option<UnitSet>,
}

/// Outcome of an export.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// Files, in their order.
    pub files: Vec<PathBuf>,
    /// Notes on the files, in sentences.
    pub notes: Vec<String>,
}

/// Exports the requested part.
///
/// # Errors
/// A folder or file without this part, a format that cannot represent it, or a file that cannot be
/// written.
pub fn export(request: &Request) -> Result<Exported, Error> {
    let is_folder = request.from.is_dir();
    let what = match request.what {
        Some(what) => what,
        None if is_folder => What::Results,
        None => {
            return Err(Error::bad_input(format!(
                "{} is a case, which has a survey and a string; choose which of them to export: \
                 survey or tally",
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
    let files = made.write(&request.from, request.output.as_ref(), what, request.format)?;
    Ok(Exported { files, notes })
}

/// Exports results in the requested format.
fn results(
    source: &Source,
    look: &Look,
    format: Format,
    notes: &mut Vec<String>,
) -> Result<Made, Error> {
    let Some(folder) = &source.folder else {
        return Err(Error::bad_input(
            "a case file has no results: give the folder of a run, a plan or a sweep",
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
            let sheets = workbook.first.iter().chain(&workbook.sheets);
            let files =
                sheets.map(|sheet| (file_stem(&sheet.name), format::csv(sheet).into_bytes()));
            Ok(Made::Files(files.collect()))
        }
        Format::Xlsx => {
            let workbook = workbook::of_folder(folder, look.units, notes)?;
            Ok(Made::File(workbook.bytes().map_err(Error::failed)?))
        }
        _ => Err(Error::bad_input(
            "results are not exported as a text report: expected CSV, Excel or WITSML",
        )),
    }
}

/// File name made from the name of a sheet.
fn file_stem(name: &str) -> String {
    name.to_lowercase().replace(' ', "_")
}
