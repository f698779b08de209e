//! A check as a page shows it.

use serde::{Deserialize, Serialize};
use wholestring::outcome::QuantityKind;
use wholestring_judge::{Check, Severity};
use wholestring_results::Status;

use crate::{Cell, dimensions::in_sets, shown_dimension};

/// A sentence of the judge with the units printed as on a page: `kN·m` for `kN.m`.
pub fn printed(sentence: &str) -> String {
    sentence.replace("N.m", "N·m").replace("ft-lbf", "ft·lbf")
}

/// A check as a page shows it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckRow {
    /// Kind of the check, as a word for programs: `lock_up`, ...
    pub kind: String,
    /// The same for users.
    pub label: String,
    /// Its severity.
    pub severity: Severity,
    /// The verdict in words: `OK`, `exceeded`, ...
    pub verdict: String,
    /// The component; empty for the rig and for the whole string.
    pub component: String,
    /// Measured depth of the place or of the upper end of its interval, m; `None` without a place.
    pub md_m: Option<f64>,
    /// Measured depth of the lower end of its interval, m; `None` for a point and without a place.
    pub to_md_m: Option<f64>,
    /// The value, for a limit the load; empty where it is not a number.
    pub value: Cell,
    /// Number that the value is compared with, for a limit the capacity; empty where there is none.
    pub limit: Cell,
    /// Capacity over load; `None` for a check that is not a limit.
    pub factor: Option<f64>,
    /// The required factor; `None` for a check that is not a limit.
    pub required: Option<f64>,
    /// A sentence for users, in SI, metric and field units.
    pub sentences: [String; 3],
}

impl CheckRow {
    /// The row of a check.
    pub fn new(check: &Check) -> Self {
        let quantity = check.kind.quantity();
        let cell = |value: Option<f64>| {
            value.map_or(Cell::Nothing, |value| match quantity {
                QuantityKind::Ratio => Cell::number(value),
                _ => Cell::quantity(value, shown_dimension(quantity)),
            })
        };
        Self {
            kind: check.kind.name().to_owned(),
            label: check.kind.label().to_owned(),
            severity: check.severity,
            verdict: check.verdict.words().to_owned(),
            component: check.component.clone().unwrap_or_default(),
            md_m: check.md_m,
            to_md_m: check.to_md_m,
            value: cell(check.value),
            limit: cell(check.limit),
            factor: check.factor,
            required: check.required,
            sentences: in_sets(|units| printed(&check.sentence_in(units))),
        }
    }
}

/// Reason why an operation ended early, in SI, metric and field units: the sentence of its check
/// where it is one; `None` where it is complete.
pub(crate) fn ended_early(status: &Status, checks: &[Check]) -> Option<[String; 3]> {
    let reason = match status {
        Status::Complete => return None,
        Status::Interrupted => "interrupted: results until then",
        Status::Failed(reason) => reason.as_str(),
    };
    let check = checks.iter().find(|check| check.sentence == reason);
    Some(in_sets(|units| match check {
        Some(check) => printed(&check.sentence_in(units)),
        None => reason.to_owned(),
    }))
}
