//! Contents of the page of a run: plain data, SI, ready to be shown.

mod facts;
mod frames;
mod history;
mod key_results;
mod page_tables;
mod time_run;
mod well;

pub(crate) use facts::facts;
pub use frames::Frames;
pub use key_results::KeyResult;
pub use time_run::{ContactPicture, Spectrum, TimeRun};
pub use well::{Part, Section, Well, path_of, well_path};

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{
    OperationSummary, OperationTables, ResultsError, Summary, Table, Unchecked,
};
use wholestring_units::UnitSet;

use crate::{CheckRow, Packed, PageHead, PageTable, check_row::ended_early, inputs::input_tables};

/// Largest number of rows of a profile on the page; longer soft-string profiles are thinned.
const MAX_NODES: usize = 3000;

/// A run as its page shows it.
///
/// Numbers are SI, angles radians. Where a number has a unit, the name of its dimension is given
/// with it, and [`PageHead::dimensions`] has its form in each set of units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Head of the page, under the name of the case.
    #[serde(flatten)]
    pub head: PageHead,
    /// The results of the models, in the order in which they were solved.
    pub solved: Vec<Solved>,
    /// The path of the well.
    pub well: Well,
    /// Sections of the hole, from the surface down.
    pub hole: Vec<Section>,
    /// Parts of the string, from the surface down.
    pub string: Vec<Part>,
    /// Time results of the operations that dynamics solved.
    pub runs: Vec<TimeRun>,
    /// Tables of numbers: results of all models, numerics, then every input.
    pub page_tables: Vec<PageTable>,
}

/// The result of one model for one operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Solved {
    /// The method.
    pub model: ModelKind,
    /// The operation.
    pub operation: OperationKind,
    /// Reason why it ended early, in SI, metric and field units; `None` where it did not.
    pub message: Option<[String; 3]>,
    /// The checks of the answer, the most severe first.
    #[serde(default)]
    pub checks: Vec<CheckRow>,
    /// Limits that could not be checked, a phrase for each missing number.
    #[serde(default)]
    pub unchecked: Vec<String>,
    /// The most important numbers, with their limits.
    pub key_results: Vec<KeyResult>,
    /// Measured depth at which the side force changes from the high to the low side, m; `None`
    /// where it does not.
    #[serde(default)]
    pub cutoff_depth_m: Option<f64>,
    /// Columns of `nodes.parquet` by their name.
    pub profile: BTreeMap<String, Packed>,
    /// Columns of `wear.parquet` by their name.
    pub wear: BTreeMap<String, Packed>,
}

impl Report {
    /// The page of a run and of its tables, without the frames; it opens in these units, by default
    /// in those of the case.
    ///
    /// # Errors
    /// Tables that cannot be read.
    pub fn new(
        summary: &Summary,
        tables: &OperationTables,
        units: Option<UnitSet>,
    ) -> Result<Self, ResultsError> {
        let in_time = summary.operations.iter().filter(|solved| solved.statistics.is_some());
        let many = in_time.clone().count();
        let run = |solved: &OperationSummary| {
            let window_s = solved.window_from_s(&summary.settings);
            TimeRun::read(solved.operation, window_s, tables, many)
        };
        let runs = in_time.map(run).collect::<Result<_, _>>()?;
        Ok(Self { runs, ..Self::along_the_hole(summary, tables, units)? })
    }

    /// The same without results against time.
    ///
    /// # Errors
    /// As [`Report::new`].
    pub fn along_the_hole(
        summary: &Summary,
        tables: &OperationTables,
        units: Option<UnitSet>,
    ) -> Result<Self, ResultsError> {
        let settings = &summary.settings;
        let solved = summary.operations.iter().map(|solved| Solved::new(solved, summary, tables));
        Ok(Self {
            head: PageHead::new(summary.case.clone(), units, Some(settings), facts(summary)),
            solved: solved.collect::<Result<_, _>>()?,
            well: Well::new(settings),
            hole: Section::all(settings),
            string: Part::all(settings),
            runs: Vec::new(),
            page_tables: [page_tables::page_tables(summary), input_tables(settings)].concat(),
        })
    }

    /// Adds the positions of the string at evenly chosen frames, as far as frames were kept.
    ///
    /// # Errors
    /// A file that cannot be read, or is damaged.
    pub fn with_frames(mut self, tables: &OperationTables) -> Result<Self, ResultsError> {
        let many = self.runs.len();
        for run in &mut self.runs {
            run.frames = Frames::read(run.operation, tables, many)?;
        }
        Ok(self)
    }
}

impl Solved {
    fn new(
        solved: &OperationSummary,
        summary: &Summary,
        tables: &OperationTables,
    ) -> Result<Self, ResultsError> {
        let table = |name| tables.read(name, Some(solved.model), solved.operation);
        let nodes = table("nodes")?;
        Ok(Self {
            model: solved.model,
            operation: solved.operation,
            message: ended_early(&solved.status, &solved.checks),
            checks: solved.checks.iter().map(CheckRow::new).collect(),
            unchecked: Unchecked::phrases(&solved.unchecked),
            // An operation without a solution has no rows and no numbers.
            key_results: match solved.scalars.hook_load_N.is_nan() {
                true => Vec::new(),
                false => key_results::key_results(solved, &summary.settings, &nodes),
            },
            cutoff_depth_m: solved.scalars.cutoff_depth_m,
            profile: columns(&nodes),
            wear: columns(&table("wear")?),
        })
    }
}

/// Numbers by the name of their column, at most [`MAX_NODES`] of each; columns without numbers are
/// left out.
fn columns(table: &Table) -> BTreeMap<String, Packed> {
    let step = table.rows().div_ceil(MAX_NODES).max(1);
    // The last row, that of the bit, is always included.
    let first = table.rows().saturating_sub(1) % step;
    let column = |name: &str| {
        let values: Vec<f64> = table.values(name).into_iter().skip(first).step_by(step).collect();
        let any = values.iter().any(|value| value.is_finite());
        any.then(|| (name.to_owned(), Packed::single(values)))
    };
    table.columns().iter().filter_map(|one| column(&one.name)).collect()
}
