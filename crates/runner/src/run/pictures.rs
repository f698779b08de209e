//! The page of a run made again, and its pictures, including those of two runs on the same axes.

use std::path::{Path, PathBuf};

use wholestring::operation::OperationKind;
use wholestring_report::{Plot, Report, Run, Spectrum, common_operations, plots};
use wholestring_results::{ResultsFolder, Summary};
use wholestring_units::UnitSet;

use crate::{
    error::Error,
    page::{FILE, PROFILE, Tables, gather, lacking, page, spectra::spectra, table},
    results_kind::{Overlay, ResultsKind},
};

/// Results of a run.
pub(crate) const RUN: ResultsKind = ResultsKind {
    noun: "a run",
    is_in: |folder| folder.join("summary.json").is_file(),
    pictures: &[],
    with_numbers: false,
    files: &[PROFILE],
    overlay: Overlay::Two,
    write_again,
    plots: |folder, units| overlaid(&[folder.to_owned()], units),
};

fn write_again(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), Error> {
    if let Some(lacking) = lacking(folder.path())? {
        return Err(Error::BadInput(lacking));
    }
    let page = page(folder.path(), units)?;
    Ok(folder.write_file(FILE, page.as_bytes())?)
}

/// Draws runs on the same axes.
///
/// # Errors
/// Folders whose results cannot be drawn, or not together.
pub(crate) fn overlaid(folders: &[PathBuf], units: Option<UnitSet>) -> Result<Vec<Plot>, Error> {
    let runs = folders.iter().map(|folder| Drawn::read(folder, units));
    drawn(&runs.collect::<Result<Vec<_>, _>>()?)
}

/// Name of the table of spectra, without its extension.
const SPECTRA: &str = "spectra";

/// A run to draw.
struct Drawn {
    folder: PathBuf,
    report: Report,
    spectra: Vec<Spectrum>,
}

impl Drawn {
    fn read(folder: &Path, units: Option<UnitSet>) -> Result<Self, Error> {
        let place = folder.display();
        let summary = Summary::read(&folder.join("summary.json"))?;
        if summary.operations.is_empty() {
            return Err(Error::bad_input(format!("nothing was solved in {place}")));
        }
        if let Some(lacking) = lacking(folder)? {
            return Err(Error::bad_input(lacking));
        }
        let tables = Tables::of_folder(folder);
        Ok(Self {
            folder: folder.to_owned(),
            report: gather(&tables, &summary, units)?,
            spectra: spectra(&table(folder, SPECTRA)?, &folder.join(format!("{SPECTRA}.parquet")))?,
        })
    }
}

/// Every picture of one run or two.
fn drawn(runs: &[Drawn]) -> Result<Vec<Plot>, Error> {
    let first = &runs[0].report;
    let alike = runs[1..].iter().any(|run| run.report.title == first.title);
    let names: Vec<String> = runs
        .iter()
        .map(|run| match alike {
            // Two runs of one case are distinguished by their folders.
            true => run.folder.display().to_string(),
            false => run.report.title.clone(),
        })
        .collect();
    let runs: Vec<Run<'_>> = runs
        .iter()
        .zip(&names)
        .map(|(run, name)| Run { name, report: &run.report, spectra: &run.spectra })
        .collect();
    if common_operations(&runs).is_empty() {
        let solved = |run: &Run<'_>| {
            let operations = common_operations(std::slice::from_ref(run));
            let names = operations.into_iter().map(OperationKind::words);
            names.collect::<Vec<_>>().join(", ")
        };
        return Err(Error::bad_input(format!(
            "nothing to overlay: {} solved {}, {} solved {}",
            names[0],
            solved(&runs[0]),
            names[1],
            solved(&runs[1])
        )));
    }
    Ok(plots(&runs, &first.units))
}
