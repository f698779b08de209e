//! The verdict of a sweep: how many of its cases have errors or warnings, and the most severe check.

use serde::Serialize;

use super::{Sweep, SweepRow};
use crate::check_row::printed;
use wholestring_judge::Severity;

/// The verdict of a sweep in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SweepVerdict {
    /// The highest severity of all cases: error, warning or OK.
    severity: Severity,
    /// Numbers of cases with errors, with warnings only, and without a complete result.
    counts: String,
    /// The most severe check, after the case that has it, in SI, metric and field units; empty where
    /// no case has any.
    sentences: [String; 3],
}

impl Sweep {
    /// The verdict from the checks of all cases; `None` where they were not checked.
    pub(crate) fn verdict(&self) -> Option<SweepVerdict> {
        if !self.checked || self.rows.is_empty() {
            return None;
        }
        let mut cases: Vec<(&[String], Tally)> = Vec::new();
        for row in &self.rows {
            let tally = match cases.iter_mut().find(|(values, _)| *values == row.values) {
                Some((_, tally)) => tally,
                None => {
                    cases.push((&row.values, Tally::default()));
                    &mut cases.last_mut()?.1
                }
            };
            tally.errors += row.errors;
            tally.warnings += row.warnings;
            tally.incomplete |= row.status != "complete";
        }
        let count = |holds: fn(&Tally) -> bool| cases.iter().filter(|case| holds(&case.1)).count();
        let errors = count(|tally| tally.errors > 0);
        let warnings = count(|tally| tally.errors == 0 && tally.warnings > 0);
        let incomplete = count(|tally| tally.incomplete);
        let all = match cases.len() {
            1 => "the one case".to_owned(),
            many => format!("{many} cases"),
        };
        let mut parts = match (errors, warnings) {
            (0, 0) => vec![format!("no errors and no warnings in {all}")],
            (0, _) => vec![format!("no errors in {all}")],
            _ => vec![format!("errors in {errors} of {all}")],
        };
        let more = if errors > 0 { " more" } else { "" };
        parts.extend((warnings > 0).then(|| format!("warnings in {warnings}{more}")));
        parts.extend((incomplete > 0).then(|| format!("{incomplete} without a complete result")));
        let severity = match (errors, warnings) {
            (0, 0) => Severity::Ok,
            (0, _) => Severity::Warning,
            _ => Severity::Error,
        };
        Some(SweepVerdict { severity, counts: parts.join(", "), sentences: self.most_severe() })
    }

    /// The most severe check of the row with the most errors, then the most warnings; the first of
    /// equal rows.
    fn most_severe(&self) -> [String; 3] {
        let rows = self.rows.iter().filter(|row| row.errors + row.warnings > 0);
        let order = |row: &&SweepRow| std::cmp::Reverse((row.errors, row.warnings));
        let Some(row) = rows.min_by_key(order) else {
            return Default::default();
        };
        let keys = self.keys.iter().zip(&row.values).map(|(key, value)| format!("{key} {value}"));
        let operation = row.operation.map(|operation| operation.words().to_owned());
        let case = keys.chain(operation).collect::<Vec<_>>().join(", ");
        row.check.each_ref().map(|check| format!("{case}: {}", printed(check)))
    }
}

/// Checks of a case, over all its models and operations.
#[derive(Default)]
struct Tally {
    errors: usize,
    warnings: usize,
    incomplete: bool,
}
