//! Headings, rows and texts of a page's tables in their usual form.

use crate::{Head, Verdict};

/// A heading, and whether the column below it has words.
pub(crate) fn head(text: impl Into<String>, words: bool) -> Head {
    Head { text: text.into(), words }
}

/// Headings, each with whether the column below it has words.
pub(crate) fn heads(names: &[(&str, bool)]) -> Vec<Head> {
    names.iter().map(|(text, words)| head(*text, *words)).collect()
}

/// A row without judged cells.
pub(crate) fn row(cells: Vec<String>) -> Vec<(String, Verdict)> {
    cells.into_iter().map(|cell| (cell, Verdict::None)).collect()
}

/// A number in four digits, and at most three decimals.
pub(crate) fn four(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let whole = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    let decimals = (3.0 - whole).clamp(0.0, 3.0) as usize;
    let text = format!("{value:.decimals$}");
    let text = if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        "0".to_owned()
    } else {
        text
    };
    text.replace('-', "\u{2212}")
}

/// The text with a capital at its beginning.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
