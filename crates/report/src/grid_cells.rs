//! Headings and rows of a page's tables, as most have them.

use crate::{Head, Verdict};

/// A heading, and whether words stand below it.
pub(crate) fn head(text: impl Into<String>, words: bool) -> Head {
    Head { text: text.into(), words }
}

/// Headings, each with whether words stand below it.
pub(crate) fn heads(names: &[(&str, bool)]) -> Vec<Head> {
    names.iter().map(|(text, words)| head(*text, *words)).collect()
}

/// A row of which nothing is judged.
pub(crate) fn row(cells: Vec<String>) -> Vec<(String, Verdict)> {
    cells.into_iter().map(|cell| (cell, Verdict::None)).collect()
}
