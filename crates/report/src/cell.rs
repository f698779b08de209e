//! Tables of a page: their values, and numbers and words as a page writes them.

use serde::{Deserialize, Serialize};

/// A value of a table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Cell {
    /// A number with a dimension.
    Quantity {
        /// The value, SI.
        value: f64,
        /// Name of its dimension, as in [`PageHead::dimensions`](crate::PageHead::dimensions).
        dimension: String,
        /// Its standard deviation, where it is a mean.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        std: Option<f64>,
    },
    /// Numbers of one dimension.
    Quantities {
        /// The values, SI.
        values: Vec<f64>,
        /// Name of their dimension.
        dimension: String,
    },
    /// A bare number.
    Number(f64),
    /// Words that link to a file next to the page.
    Link {
        /// The words.
        text: String,
        /// The file, relative to the page.
        href: String,
    },
    /// Words.
    Text(String),
    /// Empty: it does not apply.
    Nothing,
}

impl Cell {
    /// A number with a dimension; empty where it is not finite.
    pub fn quantity(value: f64, dimension: &str) -> Self {
        if !value.is_finite() {
            return Self::Nothing;
        }
        Self::Quantity { value, dimension: dimension.into(), std: None }
    }

    /// A bare number; empty where it is not finite.
    pub fn number(value: f64) -> Self {
        if value.is_finite() { Self::Number(value) } else { Self::Nothing }
    }
}

/// A table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PageTable {
    /// Place on the page.
    pub place: Place,
    /// Its title.
    pub title: String,
    /// Heads of its columns; empty where it needs none.
    pub heads: Vec<String>,
    /// Rows.
    pub rows: Vec<Vec<Cell>>,
}

/// Place of a table on the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// Among the results.
    Results,
    /// Among the numerics.
    Numerics,
    /// Among the inputs.
    Inputs,
    /// On the page of a sweep: a row for each case.
    Cases,
}

// Numbers and words as a page writes them.

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
