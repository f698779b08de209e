//! The page of a run, made from the files in its folder.

use std::path::Path;

use wholestring_report::{Report, profile, report_html};
use wholestring_results::{OperationTables, ResultsError, ResultsFolder, Summary};
use wholestring_units::UnitSet;

use super::FILE;

/// Name of the picture of all tracks.
pub(crate) const PROFILE: &str = "profile.svg";

/// Writes the page of the run in the folder; nothing if no operation was solved.
pub(crate) fn write(folder: &ResultsFolder, units: UnitSet) -> Result<(), ResultsError> {
    if !folder.path().join("summary.json").is_file() {
        return Ok(());
    }
    let page = page(folder.path(), Some(units))?;
    folder.write_file(FILE, page.as_bytes())
}

/// Adds the page and the picture of a finished run if they are missing in its folder.
pub(crate) fn complete(folder: &ResultsFolder, units: UnitSet) -> Result<(), ResultsError> {
    if !folder.path().join(PROFILE).is_file() {
        let summary = Summary::read(&folder.path().join("summary.json"))?;
        write_profile(folder, &summary, units)?;
    }
    if !folder.path().join(FILE).is_file() {
        write(folder, units)?;
    }
    Ok(())
}

/// Message for a folder with a summary but without the tables that pages and pictures require;
/// `None` if they exist.
pub(crate) fn lacking(folder: &Path) -> Result<Option<String>, ResultsError> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    let dynamic = summary.operations.iter().any(|operation| operation.statistics.is_some());
    let needed = match (summary.operations.is_empty(), dynamic) {
        (true, _) => &[][..],
        (_, true) => &["nodes", "time", "wear", "contact"],
        (_, false) => &["nodes"],
    };
    let missing: Vec<String> = needed
        .iter()
        .map(|name| format!("{name}.parquet"))
        .filter(|name| !folder.join(name).is_file())
        .collect();
    Ok((!missing.is_empty()).then(|| {
        format!(
            "{} lacks {}: run the case again; a sweep keeps them with --keep tables",
            folder.display(),
            missing.join(", ")
        )
    }))
}

/// The page of the run in a folder.
pub(crate) fn page(folder: &Path, units: Option<UnitSet>) -> Result<String, ResultsError> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    let tables = OperationTables::of_folder(folder);
    let report = Report::new(&summary, &tables, units)?.with_frames(&tables)?;
    Ok(report_html(&report))
}

/// Draws all tracks of the run in the folder; nothing if it has none.
pub(crate) fn write_profile(
    folder: &ResultsFolder,
    summary: &Summary,
    units: UnitSet,
) -> Result<(), ResultsError> {
    let tables = OperationTables::of_folder(folder.path());
    let report = Report::along_the_hole(summary, &tables, Some(units))?;
    match profile(&report, &report.head.units) {
        Some(figure) => folder.write_file(PROFILE, figure.drawing().svg().as_bytes()),
        None => folder.remove(PROFILE),
    }
}
