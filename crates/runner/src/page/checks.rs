//! Checks in the form of the page.

use wholestring::outcome::QuantityKind;
use wholestring_report::{Cell, CheckRow, shown_dimension};
use wholestring_results::Check;

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
        sentence: check.sentence.clone(),
    }
}
