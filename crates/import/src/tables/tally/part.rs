//! A component of a tally before it is written to a case.

use wholestring_tabular::TallyRow;

use super::length::Length;
use crate::error::ImportErrorKind;

/// Reason why a tally cannot be converted to a string, and the place.
pub(crate) type Refusal = (Option<String>, ImportErrorKind);

/// A component: a row, or several identical rows of one joint each.
#[derive(Debug, Clone)]
pub(crate) struct Part<'a> {
    pub(crate) rows: Vec<&'a TallyRow>,
    pub(crate) name: String,
    pub(crate) length: Length,
}

impl<'a> Part<'a> {
    /// The first of its rows, which represents all of them.
    pub(crate) fn row(&self) -> &'a TallyRow {
        self.rows[0]
    }
}
