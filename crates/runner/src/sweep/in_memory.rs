//! Many variations of a case by static models in memory: one table, no folder.

use std::{collections::BTreeMap, num::NonZeroUsize, sync::Mutex};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Override, Report, Template};
use wholestring_results::{Column, OperationSummary, Table};

use super::{read::described, table::SweepTable};
use crate::{
    cancellation::CancellationToken,
    error::{Error, Unsound},
    observer::{Observer, Silent},
    parallel::{in_parallel, jobs, lock},
    run::answer,
};

/// Largest number of reports of faulty cases; the others are counted.
const MAX_REPORTS: usize = 5;

/// Variations of a case that are solved by one static model.
pub struct Many<'a> {
    /// The case file.
    pub template: &'a Template,
    /// Changes common to all variations.
    pub overrides: &'a [Override],
    /// Changes of each variation.
    pub variations: &'a [Vec<Override>],
    /// The model, soft or stiff.
    pub model: ModelKind,
    /// The operation; by default all of the case.
    pub operation: Option<OperationKind>,
    /// Number of parallel jobs; one per core by default.
    pub jobs: Option<NonZeroUsize>,
}

/// Result of one variation.
struct Row {
    operations: Vec<OperationSummary>,
    /// Reason why it has no solution.
    failure: Option<String>,
    /// Warnings of the case.
    warnings: Vec<String>,
}

/// Solves variations of a case in memory and returns the table of a sweep: a row for each variation
/// and operation, `case` being the index of the variation. The second value is the number of
/// leading columns that contain changed keys. A variation without a solution is a row with its
/// reason.
///
/// # Errors
/// Faulty cases, in which case none is solved, or a cancellation.
pub fn solve_many(
    many: &Many<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<(Table, usize), Error> {
    let order: Vec<usize> = (0..many.variations.len()).collect();
    let threads = jobs(many.jobs);
    let solved: Mutex<BTreeMap<usize, Result<Row, Report>>> = Mutex::default();
    in_parallel(threads, &order, |number| {
        if cancellation.is_cancelled() {
            return;
        }
        let row = many.case(number).map(|case| solve(&case, cancellation));
        lock(&solved).insert(number, row);
    });
    if cancellation.is_cancelled() {
        return Err(Error::Interrupted);
    }
    let solved = solved.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut reports = Vec::new();
    let mut rows = Vec::new();
    for row in solved.into_values() {
        match row {
            Ok(row) => rows.push(row),
            Err(report) => reports.push(report),
        }
    }
    if !reports.is_empty() {
        let (faulty, all) = (reports.len(), many.variations.len());
        reports.truncate(MAX_REPORTS);
        let summary = Some(format!("{faulty} of {all} cases are faulty: none is solved"));
        return Err(Error::Unsound(Unsound { reports, summary }));
    }
    warn(&rows, observer);
    Ok(many.table(&rows))
}

impl Many<'_> {
    /// Case of a variation, with this model and operation only.
    fn case(&self, number: usize) -> Result<Case, Report> {
        let mut changes = self.overrides.to_vec();
        changes.extend(self.variations[number].iter().cloned());
        let case = self.template.case(&changes)?;
        match case.narrowed(&[self.model], self.operation) {
            Some(narrowed) => Ok(narrowed),
            None => {
                let change = |text: String| text.parse::<Override>().ok();
                changes.extend(change(format!("model={:?}", self.model.name())));
                let operation = self.operation.map(OperationKind::name);
                changes
                    .extend(operation.and_then(|name| change(format!("operation.kind={name:?}"))));
                self.template.case(&changes)
            }
        }
    }

    /// The table, and the number of its columns that are changed keys.
    fn table(&self, rows: &[Row]) -> (Table, usize) {
        let mut keys: Vec<String> = Vec::new();
        for change in self.variations.iter().flatten() {
            if !keys.contains(&change.key) {
                keys.push(change.key.clone());
            }
        }
        let mut table = SweepTable::new(keys.clone(), false, false);
        for (number, (row, changes)) in rows.iter().zip(self.variations).enumerate() {
            let value = |key: &String| {
                let change = changes.iter().rfind(|change| change.key == *key);
                change.map_or_else(String::new, |change| change.bare().to_owned())
            };
            let values: Vec<String> = keys.iter().map(value).collect();
            table.add(&values, &number.to_string(), &row.operations, row.failure.as_deref());
        }
        let described = described(&table.table(), keys.len());
        (Table::new(described.columns().iter().map(numbered).collect()), keys.len())
    }
}

/// A row for each solved operation, with the columns of a sweep: scalars, statistics, indicators,
/// findings and outcome.
pub fn operations_table(solved: &[OperationSummary]) -> Table {
    let dynamic = solved.iter().any(|operation| operation.statistics.is_some());
    let lift = solved.iter().any(|operation| operation.lift.is_some());
    let mut table = SweepTable::new(Vec::new(), dynamic, lift);
    table.add(&[], "", solved, None);
    let described = described(&table.table(), 0);
    let columns = described.columns().iter().filter(|column| column.name != "folder");
    Table::new(columns.cloned().collect())
}

/// Replaces the column of folders by the indices of the variations.
fn numbered(column: &Column) -> Column {
    match &column.data {
        wholestring_results::Data::Text(words) if column.name == "folder" => {
            let numbers = words.iter().map(|word| word.parse().ok()).collect();
            let meaning = "Number of the variation, from zero.".to_owned();
            Column { meaning, ..Column::numbers("case", numbers) }
        }
        _ => column.clone(),
    }
}

fn solve(case: &Case, cancellation: &CancellationToken) -> Row {
    let warnings =
        case.warnings.diagnostics.iter().map(|diagnostic| diagnostic.message.clone()).collect();
    match answer(case, NonZeroUsize::new(1), &Silent, cancellation) {
        Ok(solved) => Row {
            operations: solved.answers.summary().operations.clone(),
            failure: solved.stopped.map(|stop| Error::from(stop).to_string()),
            warnings,
        },
        Err(error) => Row { operations: Vec::new(), failure: Some(error.to_string()), warnings },
    }
}

/// Reports each kind of warning once: the first, with the number of cases that have it. Parts that
/// differ between cases, such as the value, follow a colon.
fn warn(rows: &[Row], observer: &dyn Observer) {
    let mut counts: BTreeMap<&str, (&str, usize)> = BTreeMap::new();
    for warning in rows.iter().flat_map(|row| &row.warnings) {
        let kind = warning.split_once(": ").map_or(warning.as_str(), |(kind, _)| kind);
        counts.entry(kind).or_insert((warning, 0)).1 += 1;
    }
    for (warning, count) in counts.into_values() {
        observer.warning(&format!("{count} of {} cases: {warning}", rows.len()));
    }
}
