//! Levels of friction as people read them.

use wholestring_results::PlanSummary;

/// From the least to the most.
pub(super) const LEVELS: [&str; 3] = ["low", "expected", "high"];

/// `0.3`, or `0.2 / 0.3` where sections differ.
pub(super) fn label(summary: &PlanSummary, name: &str) -> String {
    let sections = summary.frictions.iter().filter(|of| of.friction == name);
    let mut values: Vec<String> = sections.map(|of| short(of.along)).collect();
    values.dedup();
    values.join(" / ")
}

/// A coefficient in three decimals, without zeros at its end.
pub(super) fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
