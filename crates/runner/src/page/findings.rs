//! What an engineer must know, on its way to the page.

use wholestring::{findings::Kind, outcome::QuantityKind};
use wholestring_report::{Cell, Finding, Level, shown_dimension};
use wholestring_results::{Finding as Found, Level as Grave};

/// A finding of the summary as the page shows it.
pub(super) fn page_finding(found: &Found) -> Finding {
    let cell = |value: Option<f64>| {
        value.map_or(Cell::Nothing, |value| match dimension(&found.kind) {
            Some(dimension) => Cell::quantity(value, dimension),
            None => Cell::number(value),
        })
    };
    Finding {
        kind: found.kind.clone(),
        level: match found.level {
            Grave::Note => Level::Note,
            Grave::Warning => Level::Warning,
            Grave::Error => Level::Error,
        },
        md_m: found.md_m,
        to_md_m: found.to_md_m,
        value: cell(found.value),
        limit: cell(found.limit),
        message: found.message.clone(),
    }
}

/// What the numbers of a finding measure; nothing where they are ratios, and of a kind that this
/// version does not know.
fn dimension(kind: &str) -> Option<&'static str> {
    match Kind::named(kind)?.quantity() {
        QuantityKind::Ratio => None,
        other => Some(shown_dimension(other)),
    }
}
