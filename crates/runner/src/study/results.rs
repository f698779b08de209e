//! Results of the cases of a study, and the rows of their tables.

use std::{
    borrow::Cow,
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
    sync::Arc,
};

use wholestring::outcome::{Values, WELL_PATH};
use wholestring_case::{Override, Template};
use wholestring_report::{Section, study::Series, well_path};
use wholestring_results::{
    OperationSummary, OperationTables, ResultsError, Severity, Status, Summary,
};
use wholestring_study::{Chosen, Quantity, Selection, Source, Statistic, Study, Sweep};

use crate::{
    checks,
    error::Error,
    sweep::{self, Point},
};

/// Result of one operation of one case by one model, solved to its end.
pub(super) struct CaseResult {
    /// Index of the sweep.
    pub(super) sweep: usize,
    /// Varied keys and their values, as written.
    pub(super) keys: Vec<String>,
    pub(super) values: Vec<String>,
    pub(super) solved: OperationSummary,
    /// Folder of the tables.
    pub(super) folder: PathBuf,
}

impl CaseResult {
    pub(super) fn series(&self) -> Series {
        (self.sweep, self.solved.model, self.solved.operation)
    }

    /// Whether it belongs to the chosen series, apart from the chosen cases.
    fn is_of(&self, chosen: &Chosen) -> bool {
        let (models, operations) = (&chosen.models, &chosen.operations);
        chosen.sweeps.contains(&self.sweep)
            && (models.is_empty() || models.contains(&self.solved.model))
            && (operations.is_empty() || operations.contains(&self.solved.operation))
    }

    /// Whether it has an error.
    pub(super) fn has_error(&self) -> bool {
        checks::has_error(&self.solved)
    }

    /// The value of a varied key.
    pub(super) fn value(&self, key: &str) -> Option<&str> {
        let place = self.keys.iter().position(|name| name == key)?;
        Some(&self.values[place])
    }

    /// A number of the summary; `None` if the model does not provide it.
    pub(super) fn summary(&self, quantity: &Quantity, statistic: Statistic) -> Option<f64> {
        let name = quantity.column.name;
        let statistics = self.solved.statistics.as_ref();
        let statistics = statistics.and_then(|statistics| statistics.get(name));
        let value = match statistic {
            // The cut-off depth and constant quantities have no statistics, but a mean.
            Statistic::Mean => {
                statistics.map(|statistics| statistics.mean).or_else(|| self.scalar(name))
            }
            Statistic::Std => statistics.map(|statistics| statistics.std),
            Statistic::MeanPlusStd => statistics.map(|statistics| statistics.mean + statistics.std),
            Statistic::Min => statistics.map(|statistics| statistics.min),
            Statistic::Max => statistics.map(|statistics| statistics.max),
            Statistic::Percentile(percent) => statistics.map(|statistics| match percent < 50.0 {
                true => statistics.p05,
                false => statistics.p95,
            }),
        };
        let value = value.filter(|value| value.is_finite())?;
        Some(if quantity.magnitude { value.abs() } else { value })
    }

    fn scalar(&self, name: &str) -> Option<f64> {
        for level in [Severity::Error, Severity::Warning, Severity::Note] {
            if name.strip_suffix('s') == Some(level.name()) {
                return Some(checks::count(&self.solved, level) as f64);
            }
        }
        let solved = serde_json::to_value(&self.solved).ok()?;
        solved.get(name)?.as_f64()
    }

    /// Rows of these columns, with NaN for a number that does not apply.
    pub(super) fn rows<const N: usize>(
        &self,
        source: Source,
        names: [&str; N],
    ) -> Result<Vec<[f64; N]>, ResultsError> {
        let mut rows = Vec::new();
        self.each_row(source, names, |row| rows.push(row))?;
        Ok(rows)
    }

    /// Visits the rows of these columns in order.
    pub(super) fn each_row<const N: usize>(
        &self,
        source: Source,
        names: [&str; N],
        mut visit: impl FnMut([f64; N]),
    ) -> Result<(), ResultsError> {
        let file = match source {
            Source::Summary => return Ok(()),
            Source::Path => {
                let settings = self.settings()?;
                let path = well_path(&settings);
                let numbers = |name| {
                    let declared = WELL_PATH.iter().find(|column| column.quantity.name == name);
                    match declared.map(|declared| (declared.of)(&path)) {
                        Some(Values::Numbers(numbers)) => numbers,
                        Some(Values::Words(_)) | None => Cow::default(),
                    }
                };
                let columns = names.map(numbers);
                (0..columns[0].len())
                    .for_each(|row| visit(columns.each_ref().map(|column| column[row])));
                return Ok(());
            }
            Source::Nodes => "nodes",
            Source::Wear => "wear",
            Source::Time => "time",
            Source::Frames => "frames",
            Source::Contact => "contact",
        };
        // Only a method in time provides it.
        let timeless = matches!(source, Source::Nodes | Source::Wear);
        let OperationSummary { model, operation, .. } = self.solved;
        if !timeless && !model.in_time() {
            return Ok(());
        }
        let tables = OperationTables::of_folder(&self.folder);
        tables.pieces(file, (Some(model), operation), Some(&names), |piece| {
            let columns = names.map(|name| piece.values(name));
            (0..piece.rows()).for_each(|row| visit(columns.each_ref().map(|column| column[row])));
        })
    }

    /// Start of the window of its statistics, s.
    pub(super) fn window_from_s(&self) -> Result<f64, ResultsError> {
        Ok(self.solved.window_from_s(&self.settings()?))
    }

    /// Depths of its casing shoes, m.
    pub(super) fn shoes_m(&self) -> Result<Vec<f64>, ResultsError> {
        let settings = self.settings()?;
        let hole = Section::all(&settings).into_iter();
        let cased = hole.filter(|section| section.kind == "casing");
        Ok(cased.map(|section| section.to_m).collect())
    }

    /// All keys of the case with their values.
    fn settings(&self) -> Result<serde_json::Value, ResultsError> {
        Ok(Summary::read(&self.folder.join("summary.json"))?.settings)
    }
}

/// All results of a study, sweep by sweep.
pub(super) struct CaseResults(pub(super) Vec<CaseResult>);

impl CaseResults {
    /// Adds the complete results of a case.
    pub(super) fn add(
        &mut self,
        sweep: usize,
        (keys, values): (&[String], &[String]),
        solved: &[OperationSummary],
        folder: &Path,
    ) {
        let complete = solved.iter().filter(|solved| solved.status == Status::Complete);
        self.0.extend(complete.map(|solved| CaseResult {
            sweep,
            keys: keys.to_vec(),
            values: values.to_vec(),
            solved: solved.clone(),
            folder: folder.to_owned(),
        }));
    }

    /// Results for a figure.
    pub(super) fn chosen<'a>(&'a self, chosen: &'a Chosen) -> impl Iterator<Item = &'a CaseResult> {
        let is = |result: &&CaseResult| {
            result.is_of(chosen) && chosen.only.has(&result.keys, &result.values)
        };
        self.0.iter().filter(is)
    }

    /// Results of a series with these values, ordered by case.
    pub(super) fn of<'a>(
        &'a self,
        series: &'a Series,
        only: &'a Selection,
    ) -> impl Iterator<Item = &'a CaseResult> {
        let is = |result: &&CaseResult| {
            result.series() == *series && only.has(&result.keys, &result.values)
        };
        self.0.iter().filter(is)
    }

    /// Series of the chosen results, in their order.
    pub(super) fn series(&self, chosen: &Chosen) -> Vec<Series> {
        let mut all = Vec::new();
        for result in self.0.iter().filter(|result| result.is_of(chosen)) {
            let series = result.series();
            if !all.contains(&series) {
                all.push(series);
            }
        }
        all
    }
}

/// Unordered names of columns with their values, for data files.
pub(super) fn keys_of<'a>(results: impl Iterator<Item = &'a CaseResult>) -> Vec<String> {
    let mut keys: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    for result in results {
        keys.entry(result.sweep).or_insert_with(|| result.keys.clone());
    }
    let mut all: Vec<String> = Vec::new();
    for key in keys.into_values().flatten() {
        if !all.contains(&key) {
            all.push(key);
        }
    }
    all
}

// The cases of a study.

/// Names of the case files that a study requires, each once.
pub fn case_files(study: &Study) -> BTreeSet<&str> {
    study.sweeps.iter().flat_map(files).collect()
}

/// Cases of all sweeps, with these changes to every one of them.
pub(super) fn points(
    study: &Study,
    cases: &BTreeMap<String, Arc<Template>>,
    overrides: &[Override],
) -> Result<Vec<Point>, Error> {
    let template = |name: &str| {
        cases.get(name).ok_or_else(|| {
            Error::BadInput(format!("the study names the case `{name}`, which is not given"))
        })
    };
    let mut all = Vec::new();
    for (set, sweep) in study.sweeps.iter().enumerate() {
        for change in overrides {
            if sweep.keys().any(|key| key == change.key) {
                return Err(Error::BadInput(format!(
                    "`{}` cannot be set, sweep `{}` varies it",
                    change.key, sweep.name
                )));
            }
        }
        let keys: Vec<String> = sweep.keys().map(str::to_owned).collect();
        let mut points = sweep::points(template(&sweep.case)?, &sweep.set, &sweep.vary)?;
        for point in &mut points {
            point.set = set;
            let exceptions = sweep.exceptions.iter();
            for exception in exceptions.filter(|exception| exception.when.has(&keys, &point.values))
            {
                if let Some(case) = &exception.case {
                    point.template = template(case)?.clone();
                }
                // Varied values take precedence.
                let varied = point.changes.len() - point.values.len();
                let set = exception.set.iter().cloned();
                point.changes.splice(varied..varied, set);
            }
            let varied = point.changes.len() - point.values.len();
            let set = overrides.iter().cloned();
            point.changes.splice(varied..varied, set);
        }
        all.extend(points);
    }
    Ok(all)
}

/// Case files of a sweep.
fn files(sweep: &Sweep) -> impl Iterator<Item = &str> {
    let others = sweep.exceptions.iter().filter_map(|exception| exception.case.as_deref());
    std::iter::once(sweep.case.as_str()).chain(others)
}
