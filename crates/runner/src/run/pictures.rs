//! The page of a run made again, and its pictures, including those of two runs on the same axes.

use std::path::{Path, PathBuf};

use wholestring::operation::OperationKind;
use wholestring_report::{Plot, Report, Run, common_operations, plots};
use wholestring_results::{OperationTables, ResultsFolder, Summary};
use wholestring_units::UnitSet;

use crate::{
    error::Error,
    page::{FILE, PROFILE, lacking, page},
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
    check_summary: |path| Summary::read(path).map(drop),
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
    let reports = folders.iter().map(|folder| report(folder, units));
    let reports = reports.collect::<Result<Vec<_>, _>>()?;
    let first = &reports[0].head;
    let alike = reports[1..].iter().any(|report| report.head.title == first.title);
    let names = reports.iter().zip(folders).map(|(report, folder)| match alike {
        // Two runs of one case are distinguished by their folders.
        true => folder.display().to_string(),
        false => report.head.title.clone(),
    });
    let names: Vec<String> = names.collect();
    let runs: Vec<Run<'_>> =
        reports.iter().zip(&names).map(|(report, name)| Run { name, report }).collect();
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

/// A run to draw.
fn report(folder: &Path, units: Option<UnitSet>) -> Result<Report, Error> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    if summary.operations.is_empty() {
        let place = folder.display();
        return Err(Error::bad_input(format!("nothing was solved in {place}")));
    }
    if let Some(lacking) = lacking(folder)? {
        return Err(Error::bad_input(lacking));
    }
    let tables = OperationTables::of_folder(folder);
    tables.check_operations("spectra")?;
    Ok(Report::new(&summary, &tables, units)?)
}
