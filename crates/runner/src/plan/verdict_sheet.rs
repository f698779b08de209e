//! Sheets of a plan's checks for a reader: the verdict, and what was not checked.

use wholestring_report::{Cells, Sheet, SheetColumn};
use wholestring_results::{PlanCheck, PlanSummary};
use wholestring_units::{Dimension, UnitSet};

/// Checks of a plan: the most severe for each kind and operation.
pub(super) fn verdict_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
    let mut rows: Vec<&PlanCheck> = summary.checks.iter().collect();
    rows.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    let words = |heading: &str, meaning: &str, word: &dyn Fn(&PlanCheck) -> String| SheetColumn {
        heading: heading.to_owned(),
        unit: String::new(),
        meaning: meaning.to_owned(),
        cells: Cells::Words(rows.iter().map(|row| word(row)).collect()),
    };
    let length = Dimension::Length.unit_in(units);
    let number = |[heading, unit, meaning]: [&str; 3],
                  number: &dyn Fn(&PlanCheck) -> Option<f64>| {
        SheetColumn {
            heading: heading.to_owned(),
            unit: unit.to_owned(),
            meaning: meaning.to_owned(),
            cells: Cells::Numbers(rows.iter().map(|row| number(row)).collect()),
        }
    };
    let columns = vec![
        words("severity", "How serious it is", &|row| row.check.severity.name().to_owned()),
        words("verdict", "The verdict in words", &|row| row.check.verdict.words().to_owned()),
        words("check", "What is compared or reported", &|row| row.check.kind.label().to_owned()),
        words("operation", "The operation", &|row| row.operation.words().to_owned()),
        words("model", "The model that found it", &|row| row.model.name().to_owned()),
        words("friction", "Low, expected or high", &|row| row.friction.name().to_owned()),
        number(["bit depth", length.symbol, "Measured depth of the bit"], &|row| {
            Some(length.from_si(row.bit_depth_m))
        }),
        words("component", "The component; empty of the rig", &|row| {
            row.check.component.clone().unwrap_or_default()
        }),
        number(["measured depth", length.symbol, "Measured depth of the place"], &|row| {
            Some(length.from_si(row.check.md_m?))
        }),
        number(["factor", "", "Capacity over load"], &|row| row.check.factor),
        number(["required", "", "Required factor"], &|row| row.check.required),
        words("sentence", "The check as a sentence", &|row| row.check.sentence_in(units)),
    ];
    let about = "Of each kind of check and each operation the most severe of all models, depths and \
        frictions; plan_limits.csv has every depth and component";
    Sheet { name: "Verdict".to_owned(), about: about.to_owned(), columns }
}

/// Limits that were not checked, and what the plan leaves out; `None` where there is nothing.
pub(super) fn unchecked_sheet(summary: &PlanSummary, units: UnitSet) -> Option<Sheet> {
    let phrases = summary.unchecked.iter().map(|phrase| summary.texts.in_units(phrase, units));
    let column = SheetColumn {
        heading: "not checked".to_owned(),
        unit: String::new(),
        meaning: "Limits, with the number that is missing, and other parts left out".to_owned(),
        cells: Cells::Words(phrases.collect()),
    };
    let about = "What the verdict does not include";
    (!summary.unchecked.is_empty()).then(|| Sheet {
        name: "Not checked".to_owned(),
        about: about.to_owned(),
        columns: vec![column],
    })
}
