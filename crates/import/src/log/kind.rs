//! Kinds of logs.

use super::{csv, las, witsml};
use crate::xml;

/// Format of a log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Log ASCII Standard.
    Las,
    /// Text with a separator between its columns.
    Csv,
    /// WITSML, of either generation.
    Witsml,
}

impl Kind {
    /// The kind of a file with these first bytes; `None` if it is not a log.
    pub(crate) fn of(head: &[u8]) -> Option<Self> {
        if wholestring_tabular::is_workbook(head) {
            return None;
        }
        if let Some(root) = xml::root(head) {
            return witsml::is_log(&root.name).then_some(Kind::Witsml);
        }
        if las::is_las(head) {
            return Some(Kind::Las);
        }
        csv::is_log(head).then_some(Kind::Csv)
    }
}
