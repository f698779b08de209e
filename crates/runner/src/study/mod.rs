//! A study: a set of cases and sweeps, with the figures and tables to make of them.

mod choice;
mod columns;
mod figure;
mod frames;
mod numbers;
mod results;

pub use results::case_files;
pub use wholestring_study::Study;

use std::{collections::BTreeMap, path::Path, sync::Arc};

use wholestring_case::{Override, Report, Template};
use wholestring_report::study::{StudyFigure, StudyPage, study_html};
use wholestring_results::{ResultsError, ResultsFolder};

use self::{
    numbers::numbers,
    results::{CaseResults, keys_of},
};
use crate::{
    batch::{BatchOptions, BatchOutcome},
    cancellation::CancellationToken,
    error::Error,
    folder_name::file_name,
    keep::Keep,
    observer::Observer,
    page::{FILE, write_picture},
    share::Share,
    sweep::{Batch, CheckedPoints, Ending, Set},
};

// Request of a study, and its execution.

/// Request to carry out a study.
#[derive(Debug)]
pub struct Request<'a> {
    /// The study, as [`load`] reads it.
    pub study: &'a Study,
    /// The case files that it names, by their names in it.
    pub cases: &'a BTreeMap<String, Arc<Template>>,
    /// Changes in every case.
    pub overrides: &'a [Override],
    /// Files of each case that are kept. By default its tables if dynamics solve it, or if CSV is
    /// requested or a figure requires them, otherwise its summary.
    pub keep: Option<Keep>,
    /// Whether to also write PNG images.
    pub png: bool,
    /// Options for solving the cases.
    pub batch: BatchOptions,
}

/// Reads a study file.
///
/// # Errors
/// Every mistake in it, each with its place.
pub fn load(path: &Path) -> Result<Study, Report> {
    wholestring_study::load(path, &columns::all())
}

/// Parses a study; `name` identifies it in diagnostics.
///
/// # Errors
/// As [`load`].
pub fn parse(name: &str, text: &[u8]) -> Result<Study, Report> {
    wholestring_study::parse(name, text, &columns::all())
}

/// Checks every case of a study, solves them, and makes its figures, its tables and its page.
///
/// # Errors
/// Cases that are invalid, or a folder that cannot take the results. The state of the cases is in
/// the outcome.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<BatchOutcome, Error> {
    let (study, options) = (request.study, &request.batch);
    let points = results::points(study, request.cases, request.overrides)?;
    let valid = CheckedPoints::check(points, options, observer, cancellation)?;
    for empty in choice::without_results(study, &valid) {
        // A change of all cases, such as another model, may be meant for a first look.
        match request.overrides.is_empty() {
            true => return Err(Error::bad_input(empty)),
            false => observer.warning(&empty),
        }
    }
    let of_set = |path: &Path, set: usize| path.join(file_name(&study.sweeps[set].name));
    let claimed = valid.claim("study", &study.name, options, observer, &of_set)?;
    let folder = &claimed.folder;
    let share = Share::begin(&claimed, options.shard)?;
    let sets = study.sweeps.iter().enumerate().map(|(i, sweep)| {
        Ok(Set {
            prefix: format!("{}/", sweep.name),
            folder: ResultsFolder::create(of_set(folder.path(), i))?,
            keys: sweep.keys().map(str::to_owned).collect(),
            keep: request.keep,
            needs: if study.reads_tables_of(i) { Keep::Tables } else { Keep::Summary },
        })
    });
    let sets = sets.collect::<Result<_, Error>>()?;
    let mut batch = Batch::new(options, share, sets, valid, observer, cancellation);
    batch.solve_all()?;
    let mut results = CaseResults(Vec::new());
    for (set, point, ending) in batch.cases() {
        if let Some(Ending { solved, .. }) = ending {
            let values = (&set.keys[..], &point.values[..]);
            results.add(point.set, values, solved, &set.folder.path().join(&point.name));
        }
    }
    show(study, &results, folder, request.png)?;
    Ok(batch.outcome(folder.path()))
}

// Figures and tables of a study, and a page with all of them.

/// Writes every figure and table, and the page.
fn show(
    study: &Study,
    results: &CaseResults,
    folder: &ResultsFolder,
    png: bool,
) -> Result<(), ResultsError> {
    let sweeps: Vec<String> = study.sweeps.iter().map(|sweep| sweep.name.clone()).collect();
    let figures = within(folder, "figures")?;
    let tables = within(folder, "tables")?;
    let mut parts = Vec::new();
    for figure in &study.figures {
        let curves = figure::curves(figure, results)?;
        let drawn = StudyFigure { figure, curves: &curves, sweeps: &sweeps, units: study.units };
        let keys = keys_of(results.chosen(&figure.chosen));
        drawn.data(&keys).write_csv(&figures.path().join(format!("{}.csv", figure.name)))?;
        let picture = drawn.picture();
        write_picture(&figures, &figure.name, &picture, png)?;
        parts.push(drawn.part(picture, png));
    }
    for table in &study.tables {
        let computed = numbers(table, results, &sweeps, study.units)?;
        computed.data().write_csv(&tables.path().join(format!("{}.csv", table.name)))?;
        let grid = computed.grid();
        let text = computed.markdown(&grid);
        tables.write_file(&format!("{}.md", table.name), text.as_bytes())?;
        parts.push(computed.part(grid));
    }
    folder.write_file(FILE, study_html(&StudyPage::new(study, parts)).as_bytes())
}

fn within(folder: &ResultsFolder, name: &str) -> Result<ResultsFolder, ResultsError> {
    ResultsFolder::create(Path::join(folder.path(), name))
}
