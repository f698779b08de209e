//! `sweep.csv`: a row for each model and operation of each case of a sweep.

use serde_json::{Map, Value, json};
use wholestring::{dynamics::DynamicOutcome, outcome};
use wholestring_results::{Column, OperationSummary, Severity, Table};

use super::indicators::{INDICATORS, Indicator};

/// Name of the file.
pub const FILE: &str = "sweep.csv";

/// Scalars of an operation, named as in `summary.json`, in the order of the columns.
pub const SCALARS: [&str; outcome::SCALARS.len() + 1] = {
    let mut names = ["bit_depth_m"; outcome::SCALARS.len() + 1];
    let mut place = 1;
    while place < names.len() {
        names[place] = outcome::SCALARS[place - 1].quantity.name;
        place += 1;
    }
    names
};

/// Quantities of a tuned lift, named as in `summary.json`.
const LIFT: [&str; 3] = ["hook_load_N", "weight_on_bit_N", "runs"];

pub(super) const STATISTICS: [&str; 8] =
    ["mean", "std", "min", "max", "p05", "p95", "std_error", "drift"];

/// Rows of a sweep. The columns depend only on the varied keys and the models, so that the tables
/// of shards can be concatenated.
pub(crate) struct SweepTable {
    keys: Vec<String>,
    /// Quantity and statistic of each column.
    statistics: Vec<[&'static str; 2]>,
    /// Whether some case is dynamic.
    dynamic: bool,
    /// Whether a lift is tuned in some case.
    lift: bool,
    rows: Vec<Row>,
}

struct Row {
    values: Vec<String>,
    /// The operation as in `summary.json`; empty if a case failed before it had an answer.
    solved: Map<String, Value>,
    folder: String,
}

impl Row {
    /// Number of checks of a severity; `None` if there is no solution.
    fn checks(&self, severity: Severity) -> Option<f64> {
        let checks = self.solved.get("checks")?.as_array()?.iter();
        Some(checks.filter(|check| check["severity"] == severity.name()).count() as f64)
    }

    /// A field of the most severe check that requires attention: a text, or the parts of its
    /// sentence as JSON.
    fn worst(&self, key: &str) -> String {
        let checks = self.solved.get("checks").and_then(Value::as_array);
        let worst = checks.and_then(|checks| checks.first());
        let worst = worst.filter(|check| check["severity"] != Severity::Ok.name());
        match worst.map(|check| &check[key]) {
            Some(Value::String(word)) => word.clone(),
            Some(Value::Array(parts)) if !parts.is_empty() => json!(parts).to_string(),
            _ => String::new(),
        }
    }
}

impl SweepTable {
    /// Creates a table for a sweep of these keys; `dynamic` and `lift` are true if any case is
    /// dynamic or has a tuned lift.
    pub(crate) fn new(keys: Vec<String>, dynamic: bool, lift: bool) -> Self {
        let statistics = DynamicOutcome::quantities()
            .filter(|_| dynamic)
            .flat_map(|quantity| STATISTICS.map(|statistic| [quantity, statistic]))
            // The mean of a scalar is the scalar itself.
            .filter(|[quantity, statistic]| *statistic != "mean" || !SCALARS.contains(quantity))
            .collect();
        Self { keys, statistics, dynamic, lift, rows: Vec::new() }
    }

    /// Adds the results of a case, and the reason of its failure if it adds information.
    pub(crate) fn add(
        &mut self,
        values: &[String],
        folder: &str,
        solved: &[OperationSummary],
        failure: Option<&str>,
    ) {
        let mut row = |solved: Map<String, Value>| {
            self.rows.push(Row { values: values.to_vec(), solved, folder: folder.to_owned() });
        };
        let mut explained = false;
        for operation in solved {
            if let Ok(Value::Object(operation)) = serde_json::to_value(operation) {
                explained |= operation.get("status").is_some_and(|status| status == "failed");
                row(operation);
            }
        }
        if let (Some(failure), false) = (failure, explained) {
            row([("status", "failed"), ("message", failure)]
                .map(|(key, word)| (key.to_owned(), word.into()))
                .into_iter()
                .collect());
        }
    }

    /// The table: varied keys, model and operation, scalars, statistics, start of the window and
    /// drifting quantities, indicators, the lift, checks, outcome, and the folder of the other
    /// results.
    pub(crate) fn table(&self) -> Table {
        let text = |name: &str, row: &dyn Fn(&Row) -> String| {
            Column::words(name, self.rows.iter().map(row).collect())
        };
        let word = |name: &str| {
            text(name, &|row| {
                let word = row.solved.get(name).and_then(Value::as_str);
                word.unwrap_or_default().to_owned()
            })
        };
        let number = |name: String, row: &dyn Fn(&Row) -> Option<f64>| {
            Column::numbers(name, self.rows.iter().map(row).collect())
        };
        let mut columns = Vec::new();
        for (i, key) in self.keys.iter().enumerate() {
            columns.push(text(key, &|row| row.values[i].clone()));
        }
        columns.extend(["model", "operation"].map(word));
        for name in SCALARS {
            columns.push(number(name.to_owned(), &|row| row.solved.get(name)?.as_f64()));
        }
        for [quantity, statistic] in &self.statistics {
            let name = format!("{quantity}_{statistic}");
            columns.push(number(name, &|row| {
                let statistics = row.solved.get("statistics")?;
                statistics.get(quantity)?.get(statistic)?.as_f64()
            }));
        }
        if self.dynamic {
            columns.push(number("settle_s".to_owned(), &|row| {
                row.solved.get("numerics")?.get("settle_s")?.as_f64()
            }));
            columns.push(text("drifting", &|row| drifting(&row.solved)));
            for Indicator { path, about: (name, ..) } in INDICATORS {
                columns.push(number((*name).to_owned(), &|row| {
                    let indicators = row.solved.get("indicators")?;
                    path.iter().try_fold(indicators, |value, key| value.get(key))?.as_f64()
                }));
            }
        }
        for name in LIFT.into_iter().filter(|_| self.lift) {
            columns.push(number(format!("lift_{name}"), &|row| {
                row.solved.get("lift")?.get(name)?.as_f64()
            }));
        }
        for (name, severity) in [("errors", Severity::Error), ("warnings", Severity::Warning)] {
            columns.push(number(name.to_owned(), &|row| row.checks(severity)));
        }
        for (name, key) in [
            ("worst_check", "kind"),
            ("worst_check_sentence", "sentence"),
            ("worst_check_parts", "parts"),
        ] {
            columns.push(text(name, &|row| row.worst(key)));
        }
        columns.extend(["status", "message"].map(word));
        columns.push(text("folder", &|row| row.folder.clone()));
        Table::new(columns)
    }
}

/// Quantities that drift over the window of an operation, separated by blanks.
fn drifting(solved: &Map<String, Value>) -> String {
    let statistics = solved.get("statistics").and_then(Value::as_object);
    let drifts = |statistic: &Value| statistic.get("drifts").and_then(Value::as_bool) == Some(true);
    let names = statistics.into_iter().flatten();
    let names = names.filter_map(|(name, statistic)| drifts(statistic).then_some(name.as_str()));
    names.collect::<Vec<_>>().join(" ")
}
