//! `report.html`: the page of a run, made from the files that it left.

mod answers;
pub(crate) mod asked;
pub(crate) mod dimensions;
mod findings;
mod frames;
pub(crate) mod history;
pub(crate) mod inputs;
mod sheets;
pub(crate) mod spectra;
pub(crate) mod well;

use std::path::{Path, PathBuf};

use wholestring_report::{Packed, Report, Solved, TimeRun, report_html};
use wholestring_results::{OperationSummary, ResultsError, ResultsFolder, Status, Summary, Table};
use wholestring_units::UnitSet;

use crate::{
    args::ReportArgs,
    bit_test::page as bit_test,
    column::{numbers, words},
    failure::Failure,
    record::{PROFILE, write_profile},
    say,
    sweep::report as sweep,
};

/// Name of the file.
pub(crate) const FILE: &str = "report.html";

/// What made the page.
pub(crate) const PROGRAM: &str = concat!("wholestring ", env!("CARGO_PKG_VERSION"));

/// Rows of a profile that a page shows: of a soft string every few where there are more.
const MOST_NODES: usize = 3000;

/// `wholestring report DIR`.
pub(crate) fn report(args: &ReportArgs) -> Result<(), Failure> {
    let place = args.folder.display();
    let bad = |error: &dyn std::fmt::Display| Failure::BadInput(format!("error: {error}"));
    // Whatever the folder holds is the input here.
    if bit_test::is_bit_test(&args.folder) {
        let test = bit_test::gather(&args.folder, args.units).map_err(|error| bad(&error))?;
        bit_test::write(&ResultsFolder::create(&args.folder)?, &test)?;
    } else if args.folder.join("summary.json").is_file() {
        if let Some(lacking) = lacking(&args.folder).map_err(|error| bad(&error))? {
            return Err(bad(&lacking));
        }
        let page = page(&args.folder, args.units).map_err(|error| bad(&error))?;
        let folder = ResultsFolder::create(&args.folder)?;
        folder.write_file(FILE, page.as_bytes())?;
    } else if sweep::is_sweep(&args.folder) {
        let folder = ResultsFolder::create(&args.folder)?;
        sweep::write(&folder, args.units).map_err(|error| bad(&error))?;
    } else {
        return Err(bad(&format!(
            "{place} is no folder of a run, a sweep or a bit test: it holds neither summary.json nor sweep.csv"
        )));
    }
    say(&format!("{}\n", args.folder.join(FILE).display()))
}

/// Writes the page of the run whose files are in the folder; nothing where nothing was solved.
pub(crate) fn write(folder: &ResultsFolder, units: UnitSet) -> Result<(), Failure> {
    if !folder.path().join("summary.json").is_file() {
        return Ok(());
    }
    let page = page(folder.path(), Some(units))?;
    Ok(folder.write_file(FILE, page.as_bytes())?)
}

/// Makes the page and the picture of a run that is finished where its folder lacks them.
pub(crate) fn complete(folder: &ResultsFolder, units: UnitSet) -> Result<(), Failure> {
    if !folder.path().join(PROFILE).is_file() {
        let summary = Summary::read(&folder.path().join("summary.json"))?;
        let (nodes, wear) = (
            table(folder.path(), "nodes")?,
            table(folder.path(), "wear")?,
        );
        write_profile(
            folder,
            &along_the_hole(&nodes, &wear, &summary, Some(units)),
        )?;
    }
    if !folder.path().join(FILE).is_file() {
        write(folder, units)?;
    }
    Ok(())
}

/// What is said of a folder with a summary that lacks tables from which pages and pictures are made; nothing where
/// they are there.
pub(crate) fn lacking(folder: &Path) -> Result<Option<String>, ResultsError> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    let dynamic = summary.operations.iter().any(|of| of.statistics.is_some());
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
fn page(folder: &Path, units: Option<UnitSet>) -> Result<String, ResultsError> {
    let summary = Summary::read(&folder.join("summary.json"))?;
    let mut report = gather(&Tables::read(folder)?, &summary, units)?;
    let mut frames = frames::read(folder, report.runs.len())?;
    for run in &mut report.runs {
        run.frames = frames.remove(&run.operation);
    }
    Ok(report_html(&report))
}

/// The tables of a run, without rows where there is none. Those against time are large, and are
/// read operation by operation.
pub(crate) struct Tables {
    folder: PathBuf,
    nodes: Table,
    wear: Table,
    bottom_hole: Table,
}

impl Tables {
    /// Those in a folder.
    pub(crate) fn read(folder: &Path) -> Result<Self, ResultsError> {
        Ok(Self {
            folder: folder.to_owned(),
            nodes: table(folder, "nodes")?,
            wear: table(folder, "wear")?,
            bottom_hole: table(folder, "bottom_hole")?,
        })
    }

    /// A table against time, as far as it is about an operation.
    fn of(&self, name: &str, operation: &str) -> Result<Table, ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        let rows = if path.is_file() {
            Table::read_parquet_with(&path, "operation", operation)?
        } else {
            None
        };
        Ok(rows.unwrap_or_else(|| Table::new(Vec::new())))
    }
}

/// A table of the folder, without rows where there is none.
pub(crate) fn table(folder: &Path, name: &str) -> Result<Table, ResultsError> {
    let path = folder.join(format!("{name}.parquet"));
    if path.is_file() {
        Table::read_parquet(&path)
    } else {
        Ok(Table::new(Vec::new()))
    }
}

/// What is told of a run; all but the string at moments.
///
/// # Errors
/// Tables that cannot be read.
pub(crate) fn gather(
    tables: &Tables,
    summary: &Summary,
    units: Option<UnitSet>,
) -> Result<Report, ResultsError> {
    let runs: Vec<&OperationSummary> = summary
        .operations
        .iter()
        .filter(|solved| solved.statistics.is_some())
        .collect();
    let many = runs.len();
    let timed = |solved: &&OperationSummary| {
        let time = tables.of("time", &solved.operation)?;
        let contact = tables.of("contact", &solved.operation)?;
        let spectra = tables.of("spectra", &solved.operation)?;
        let history = history::history(&time, &solved.operation, many);
        let window_s = solved.window_from_s(&summary.settings);
        Ok(TimeRun {
            operation: solved.operation.clone(),
            window_s,
            samples: history.samples,
            history: history.columns,
            notes: history.notes,
            contact: history::contact(&contact, &solved.operation, many),
            frames: None,
            drill_off: history::drill_off(&time, &solved.operation, window_s, many),
            bottom: history::bottom(&tables.bottom_hole, &solved.operation),
            spectra: spectra::pictures(&spectra, &solved.operation),
        })
    };
    Ok(Report {
        runs: runs
            .iter()
            .map(timed)
            .collect::<Result<_, ResultsError>>()?,
        ..along_the_hole(&tables.nodes, &tables.wear, summary, units)
    })
}

/// What is told of a run along its hole, and nothing of what it did in time.
pub(crate) fn along_the_hole(
    nodes: &Table,
    wear: &Table,
    summary: &Summary,
    units: Option<UnitSet>,
) -> Report {
    let settings = &summary.settings;
    let well = well::WellBore::of(settings);
    Report {
        program: PROGRAM.into(),
        title: summary.case.clone(),
        units: match units {
            Some(units) => units.name().into(),
            None => settings["units"].as_str().unwrap_or("si").into(),
        },
        told_in: settings["units"].as_str().unwrap_or("si").into(),
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
                findings: solved.findings.iter().map(findings::told).collect(),
                answers: answers::answers(solved, settings, nodes),
                profile: columns(nodes, Some(solved.model.name()), &solved.operation),
                wear: columns(wear, Some(solved.model.name()), &solved.operation),
            })
            .collect(),
        well: well.path(),
        hole: well.hole(),
        string: well.string(),
        runs: Vec::new(),
        sheets: [
            sheets::results(summary),
            sheets::numerics(summary),
            inputs::sheets(settings),
        ]
        .concat(),
    }
}

/// Rows of a table that belong to an operation, and to a model where the table tells them apart.
fn rows(table: &Table, model: Option<&str>, operation: &str) -> Vec<usize> {
    let models = words(table, "model");
    let operations = words(table, "operation").iter().enumerate();
    operations
        .filter(|(row, name)| {
            // A table that does not tell models apart is that of the one in time.
            let of = models.get(*row);
            let others = of.zip(model).is_some_and(|(of, model)| of != model);
            *name == operation && !others
        })
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
