//! A component of a tally on its way to a case.

use wholestring_tabular::TallyRow;

use super::length::Length;
use crate::error::ImportErrorKind;

/// Why a tally cannot be made a string, and where.
pub(crate) type Refusal = (Option<String>, ImportErrorKind);

/// A component: a row, or several alike, one joint each.
#[derive(Debug, Clone)]
pub(crate) struct Part<'a> {
    pub(crate) rows: Vec<&'a TallyRow>,
    pub(crate) name: String,
    pub(crate) length: Length,
}

impl<'a> Part<'a> {
    /// The first of its rows, which says what all of them are.
    pub(crate) fn row(&self) -> &'a TallyRow {
        self.rows[0]
    }
}
