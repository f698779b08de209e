//! Rows of `sweep.csv`.

use std::{collections::BTreeMap, path::Path};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_judge::Wording;
use wholestring_results::{Data, ResultsError, Table};

use crate::dimensions::in_sets;

/// The result of one model for one operation of one case.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SweepRow {
    /// The values of the keys, as they were written.
    pub(crate) values: Vec<String>,
    /// The method; none where the case had no answer.
    pub(crate) model: Option<ModelKind>,
    /// The operation; none where the case had no answer.
    pub(crate) operation: Option<OperationKind>,
    /// `complete`, `interrupted` or `failed`.
    pub(crate) status: String,
    /// Columns of `sweep.csv` that hold a number here.
    pub(crate) numbers: BTreeMap<String, f64>,
    /// Number of checks that are errors.
    pub(crate) errors: usize,
    /// Number of checks that are warnings.
    pub(crate) warnings: usize,
    /// Sentence of the most severe check, in SI, metric and field units; empty where there is none.
    pub(crate) check: [String; 3],
    /// The page of the case, relative to that of the sweep; `None` where the case has none.
    pub(crate) page: Option<String>,
}

impl SweepRow {
    /// Reads the rows of a table of words after the values of the keys; `path` is its file.
    pub(super) fn read(
        answers: &Table,
        values: impl Fn(usize) -> Vec<String>,
        page: impl Fn(&str) -> Option<String>,
        path: &Path,
    ) -> Result<Vec<Self>, ResultsError> {
        let word =
            |name: &str, row: usize| answers.words(name).map_or("", |words| words[row].as_str());
        let number = |row: usize| {
            answers.columns().iter().filter_map(move |column| match &column.data {
                Data::Text(words) => Some((column.name.clone(), words[row].parse().ok()?)),
                Data::Number(_) => None,
            })
        };
        // Sweeps of versions without checks have no such columns.
        let count = |name: &str, row: usize| word(name, row).parse::<f64>().unwrap_or(0.0) as usize;
        let row = |row: usize| {
            let sentence = match word("worst_check_sentence", row) {
                // Column of earlier versions.
                "" => word("worst_finding_message", row),
                sentence => sentence,
            };
            Ok(Self {
                values: values(row),
                model: known("model", word("model", row), ModelKind::named, path)?,
                operation: known(
                    "operation",
                    word("operation", row),
                    OperationKind::from_name,
                    path,
                )?,
                status: word("status", row).to_owned(),
                numbers: number(row).collect(),
                errors: count("errors", row),
                warnings: count("warnings", row),
                check: match serde_json::from_str::<Wording>(word("worst_check_parts", row)) {
                    Ok(wording) => in_sets(|units| wording.in_units(units)),
                    Err(_) => in_sets(|_| sentence.to_owned()),
                },
                page: Some(word("folder", row)).filter(|case| !case.is_empty()).and_then(&page),
            })
        };
        (0..answers.rows()).map(row).collect()
    }
}

/// The model or the operation of a name; `None` for a case that failed before it had any.
fn known<T>(
    noun: &str,
    name: &str,
    named: fn(&str) -> Option<T>,
    path: &Path,
) -> Result<Option<T>, ResultsError> {
    let found = named(name);
    match name.is_empty() || found.is_some() {
        true => Ok(found),
        false => Err(ResultsError::Format {
            path: path.to_owned(),
            reason: format!("'{name}' is no {noun}"),
        }),
    }
}
