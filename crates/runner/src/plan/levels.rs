//! Names of friction levels.

use wholestring_results::PlanSummary;

/// From low to high.
pub(super) const LEVELS: [&str; 3] = ["low", "expected", "high"];

/// Friction factors of a level: `0.3`, or `0.2 / 0.3` if sections differ.
pub(super) fn label(summary: &PlanSummary, name: &str) -> String {
    let sections = summary.frictions.iter().filter(|friction| friction.friction == name);
    let mut values: Vec<String> = sections.map(|section| short(section.along)).collect();
    values.dedup();
    values.join(" / ")
}

/// A coefficient in three decimals, without trailing zeros.
pub(super) fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
