//! Headings and rows of a page's tables in their usual form.

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
