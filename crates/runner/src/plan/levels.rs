//! Friction of the levels, in words.

use wholestring::well::FrictionLevel;
use wholestring_results::PlanSummary;

/// Friction factors of a level: `0.3`, or `0.2 / 0.3` if sections differ.
pub(super) fn label(summary: &PlanSummary, level: FrictionLevel) -> String {
    let sections = summary.frictions.iter().filter(|friction| friction.friction == level);
    let mut values: Vec<String> = sections.map(|section| short(section.along)).collect();
    values.dedup();
    values.join(" / ")
}

/// A coefficient in three decimals, without trailing zeros.
pub(super) fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
