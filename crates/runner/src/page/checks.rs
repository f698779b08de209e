//! Checks in the form of the page.

use wholestring::outcome::QuantityKind;
use wholestring_report::{Cell, CheckRow, printed, shown_dimension};
use wholestring_results::{Check, Status};
use wholestring_units::UnitSet;

use super::dimensions::SETS;

/// A text in SI, metric and field units.
pub(crate) fn in_sets<T>(text: impl FnMut(UnitSet) -> T) -> [T; 3] {
    SETS.map(text)
}

/// Reason why an operation ended early: the sentence of its check where it is one.
pub(crate) fn message(status: &Status, checks: &[Check]) -> Option<[String; 3]> {
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

/// Converts a check of the summary to a row of the page.
pub(crate) fn row(check: &Check) -> CheckRow {
    let quantity = check.kind.quantity();
    let cell = |value: Option<f64>| {
        value.map_or(Cell::Nothing, |value| match quantity {
            QuantityKind::Ratio => Cell::number(value),
            _ => Cell::quantity(value, shown_dimension(quantity)),
        })
    };
    CheckRow {
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
