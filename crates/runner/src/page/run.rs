//! The page of a run, made from the files in its folder.

use std::path::Path;

use wholestring_report::{
    CheckRow, PROGRAM, Report, Solved, TimeRun, display_units, ended_early, opening_units,
    report_html,
};
use wholestring_results::{OperationSummary, ResultsError, ResultsFolder, Summary, Unchecked};
use wholestring_units::UnitSet;

use super::{
    facts,
    file::FILE,
    frames,
    history::{self, History},
    inputs, page_tables,
    profile::{PROFILE, write_profile},
    results,
    rows::columns,
    spectra,
    tables::Tables,
    well,
};

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
        let tables = Tables::of_folder(folder.path());
        write_profile(folder, &along_the_hole(&tables, &summary, Some(units))?)?;
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
    let mut report = gather(&Tables::of_folder(folder), &summary, units)?;
    let mut frames = frames::read(folder, report.runs.len())?;
    for run in &mut report.runs {
        run.frames = frames.remove(run.operation.name());
    }
    Ok(report_html(&report))
}

/// Page data of a run, except the positions of the string.
///
/// # Errors
/// Tables that cannot be read.
pub(crate) fn gather(
    tables: &Tables,
    summary: &Summary,
    units: Option<UnitSet>,
) -> Result<Report, ResultsError> {
    let runs: Vec<&OperationSummary> =
        summary.operations.iter().filter(|solved| solved.statistics.is_some()).collect();
    let many = runs.len();
    let timed = |solved: &&OperationSummary| {
        let contact = tables.of("contact", solved.operation)?;
        let spectra = tables.of("spectra", solved.operation)?;
        let bottom = tables.of("bottom_hole", solved.operation)?;
        let window_s = solved.window_from_s(&summary.settings);
        let history = History::of(tables, solved.operation, window_s, many)?;
        Ok(TimeRun {
            operation: solved.operation,
            window_s,
            samples: history.samples,
            history: history.columns,
            notes: history.notes,
            contact: history::contact(&contact, solved.operation, many),
            frames: None,
            drill_off: history.drill_off,
            bottom: history::bottom(&bottom, solved.operation),
            spectra: spectra::pictures(&spectra, solved.operation),
        })
    };
    Ok(Report {
        runs: runs.iter().map(timed).collect::<Result<_, ResultsError>>()?,
        ..along_the_hole(tables, summary, units)?
    })
}

/// Page data of a run along its hole, without time histories.
///
/// # Errors
/// Tables that cannot be read.
pub(crate) fn along_the_hole(
    tables: &Tables,
    summary: &Summary,
    units: Option<UnitSet>,
) -> Result<Report, ResultsError> {
    let settings = &summary.settings;
    let well = well::WellBore::of(settings);
    let along = |solved: &OperationSummary| {
        let nodes = tables.of("nodes", solved.operation)?;
        let wear = tables.of("wear", solved.operation)?;
        Ok(Solved {
            model: solved.model,
            operation: solved.operation,
            message: ended_early(&solved.status, &solved.checks),
            checks: solved.checks.iter().map(CheckRow::new).collect(),
            unchecked: Unchecked::phrases(&solved.unchecked),
            // An operation without a solution has no rows and no numbers.
            key_results: match solved.scalars.hook_load_N.is_nan() {
                true => Vec::new(),
                false => results::key_results(solved, settings, &nodes),
            },
            cutoff_depth_m: solved.scalars.cutoff_depth_m,
            profile: columns(&nodes, Some(solved.model), solved.operation),
            wear: columns(&wear, Some(solved.model), solved.operation),
        })
    };
    Ok(Report {
        program: PROGRAM.into(),
        title: summary.case.clone(),
        units: opening_units(units, Some(settings)),
        dimensions: display_units(),
        facts: facts::facts(summary),
        solved: summary.operations.iter().map(along).collect::<Result<_, ResultsError>>()?,
        well: well.path(),
        hole: well.hole(),
        string: well.string(),
        runs: Vec::new(),
        page_tables: [
            page_tables::results(summary),
            page_tables::numerics(summary),
            inputs::page_tables(settings),
        ]
        .concat(),
    })
}
