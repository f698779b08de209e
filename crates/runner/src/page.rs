//! `report.html`: pages and pictures of results, made from their files.

pub(crate) use wholestring_report::PROGRAM;

use std::{io, path::Path};

use wholestring_contain::{Panicked, contain};
use wholestring_report::{Report, figure::Figure, profile, report_html};
use wholestring_results::{
    OperationTables, ReadRow, ResultsError, ResultsFolder, Summary, TABLES, Table,
};
use wholestring_units::UnitSet;

use crate::error::mistake_of;

/// Name of the file.
pub(crate) const FILE: &str = "report.html";

/// Dots per inch that printers and journals require.
const DOTS_PER_INCH: f64 = 300.0;

/// Writes a picture as SVG, and as PNG if requested.
///
/// # Errors
/// Files that cannot be written.
pub fn write_picture(
    folder: &ResultsFolder,
    name: &str,
    figure: &Figure,
    png: bool,
) -> Result<(), ResultsError> {
    let path = folder.path().join(format!("{name}.svg"));
    let images = contain(|| {
        let drawing = figure.drawing();
        (drawing.svg(), png.then(|| drawing.png(DOTS_PER_INCH)))
    });
    let (svg, painted) = images.map_err(|Panicked(mistake)| ResultsError::Write {
        path,
        source: io::Error::other(mistake_of(&mistake)),
    })?;
    folder.write_file(&format!("{name}.svg"), svg.as_bytes())?;
    let name = format!("{name}.png");
    match painted {
        Some(bytes) => folder.write_file(&name, &bytes),
        // An earlier PNG image does not belong to the new picture.
        None => folder.remove(&name),
    }
}

// The page of a run, made from the files in its folder.

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

// Whole tables in a folder of results.

/// A whole table of the folder with all of its declared columns; without rows if the file does not
/// exist.
///
/// # Errors
/// A file that cannot be read, or contains another table.
pub(crate) fn table(folder: &Path, name: &str) -> Result<Table, ResultsError> {
    let path = folder.join(format!("{name}.parquet"));
    if !path.is_file() {
        return Ok(Table::new(Vec::new()));
    }
    let table = Table::read_parquet(&path)?;
    match TABLES.iter().find(|(known, _)| *known == name) {
        Some((_, declared)) => table.with_declared(declared, &path),
        None => Ok(table),
    }
}

/// The rows of a whole table of the folder; none if the file does not exist.
///
/// # Errors
/// As [`table`], and a value that a row cannot have.
pub(crate) fn read_rows<R: ReadRow>(folder: &Path, name: &str) -> Result<Vec<R>, ResultsError> {
    rows_of(&table(folder, name)?, &folder.join(format!("{name}.parquet")))
}

/// The rows of a [`table`] that was read from `path`.
///
/// # Errors
/// A value that a row cannot have.
pub(crate) fn rows_of<R: ReadRow>(table: &Table, path: &Path) -> Result<Vec<R>, ResultsError> {
    match table.columns().is_empty() {
        true => Ok(Vec::new()),
        false => R::read(table, path),
    }
}
