//! `report.html`: the page of a run, made from the files that it left.

mod answers;
mod asked;
pub(crate) mod dimensions;
mod frames;
mod history;
mod inputs;
mod sheets;
pub(crate) mod well;

use std::path::Path;

use wholestring_report::{Packed, Report, Solved, TimeRun, report_html};
use wholestring_results::{OperationSummary, ResultsError, ResultsFolder, Status, Summary, Table};
use wholestring_units::UnitSet;

use crate::{
    args::ReportArgs,
    column::{numbers, words},
    failure::Failure,
    say,
};

/// Name of the file.
const FILE: &str = "report.html";

/// Rows of a profile that a page shows: of a soft string every few where there are more.
const MOST_NODES: usize = 3000;

/// `wholestring report DIR`.
pub(crate) fn report(args: &ReportArgs) -> Result<(), Failure> {
    if !args.folder.join("summary.json").is_file() {
        let place = args.folder.display();
        return Err(Failure::BadInput(format!(
            "error: {place} is no folder of a run: it holds no summary.json"
        )));
    }
    // Whatever the folder holds is the input here.
    let page = page(&args.folder, args.units)
        .map_err(|error| Failure::BadInput(format!("error: {error}")))?;
    let folder = ResultsFolder::create(&args.folder)?;
    folder.write_text(FILE, &page)?;
    say(&format!("{}\n", folder.path().join(FILE).display()))
}

/// Writes the page of the run whose files are in the folder; nothing where nothing was solved.
pub(crate) fn write(folder: &ResultsFolder, units: UnitSet) -> Result<(), Failure> {
    if !folder.path().join("summary.json").is_file() {
        return Ok(());
    }
    let page = page(folder.path(), Some(units))?;
    Ok(folder.write_text(FILE, &page)?)
}

/// The page of the run in a folder.
fn page(folder: &Path, units: Option<UnitSet>) -> Result<String, ResultsError> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    Ok(report_html(&gather(folder, &summary, units)?))
}

/// Everything that the page tells.
fn gather(
    folder: &Path,
    summary: &Summary,
    units: Option<UnitSet>,
) -> Result<Report, ResultsError> {
    let nodes = table(folder, "nodes")?;
    let wear = table(folder, "wear")?;
    let time = table(folder, "time")?;
    let contact = table(folder, "contact")?;
    let settings = &summary.settings;
    let well = well::WellBore::of(settings);
    let runs: Vec<&OperationSummary> = summary
        .operations
        .iter()
        .filter(|solved| solved.statistics.is_some())
        .collect();
    let mut frames = frames::read(folder, &runs)?;
    let many = runs.len();
    Ok(Report {
        program: concat!("wholestring ", env!("CARGO_PKG_VERSION")).into(),
        title: summary.case.clone(),
        units: match units {
            Some(units) => units.name().into(),
            None => settings["units"].as_str().unwrap_or("si").into(),
        },
        dimensions: dimensions::all(),
        asked: asked::asked(summary),
        solved: summary
            .operations
            .iter()
            .map(|solved| Solved {
                model: solved.model.name().into(),
                operation: solved.operation.clone(),
                message: match &solved.status {
                    Status::Complete => None,
                    Status::Interrupted => Some("interrupted: what was computed until then".into()),
                    Status::Failed(reason) => Some(reason.clone()),
                },
                answers: answers::answers(solved, settings, &nodes),
                profile: columns(&nodes, Some(solved.model.name()), &solved.operation),
                wear: match solved.model {
                    wholestring::outcome::ModelKind::Dynamic => {
                        columns(&wear, None, &solved.operation)
                    }
                    wholestring::outcome::ModelKind::Soft => Default::default(),
                },
            })
            .collect(),
        well: well.path(),
        hole: well.hole(),
        string: well.string(),
        runs: runs
            .iter()
            .map(|solved| {
                let history = history::history(&time, &solved.operation, many);
                TimeRun {
                    operation: solved.operation.clone(),
                    window_s: settings["dynamics"]["settle_s"].as_f64().unwrap_or(0.0),
                    samples: history.samples,
                    history: history.columns,
                    notes: history.notes,
                    contact: history::contact(&contact, &solved.operation, many),
                    frames: frames.remove(&solved.operation),
                }
            })
            .collect(),
        sheets: [
            sheets::results(summary),
            sheets::numerics(summary),
            inputs::sheets(settings),
        ]
        .concat(),
    })
}

/// A table of the folder, without rows where there is none.
fn table(folder: &Path, name: &str) -> Result<Table, ResultsError> {
    let path = folder.join(format!("{name}.parquet"));
    if path.is_file() {
        Table::read_parquet(&path)
    } else {
        Ok(Table::new(Vec::new()))
    }
}

/// Rows of a table that belong to an operation, and to a model where the table tells them apart.
fn rows(table: &Table, model: Option<&str>, operation: &str) -> Vec<usize> {
    let models = words(table, "model");
    let operations = words(table, "operation").iter().enumerate();
    operations
        .filter(|(row, name)| *name == operation && model.is_none_or(|model| models[*row] == model))
        .map(|(row, _)| row)
        .collect()
}

/// The numbers of those rows by the name of their column; columns that hold none are left out.
fn columns(
    table: &Table,
    model: Option<&str>,
    operation: &str,
) -> std::collections::BTreeMap<String, Packed> {
    let rows = rows(table, model, operation);
    let step = rows.len().div_ceil(MOST_NODES).max(1);
    // The last row, the bit's, is always among them.
    let last = rows.len().saturating_sub(1);
    let chosen: Vec<usize> = rows
        .iter()
        .enumerate()
        .filter(|(place, _)| (last - place).is_multiple_of(step))
        .map(|(_, row)| *row)
        .collect();
    let names = table.columns().iter().map(|column| column.name.as_str());
    names
        .filter_map(|name| {
            let all = numbers(table, name);
            let values: Vec<f64> = chosen
                .iter()
                .map(|row| all.get(*row).copied().flatten().unwrap_or(f64::NAN))
                .collect();
            let any = values.iter().any(|value| value.is_finite());
            any.then(|| (name.to_owned(), Packed::single(values)))
        })
        .collect()
}
