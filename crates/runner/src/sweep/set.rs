//! Cases with a folder and a table of their own.

use wholestring_case::Case;
use wholestring_results::ResultsFolder;

use crate::keep::Keep;

/// Cases with a folder and a table of their own.
pub(crate) struct Set {
    /// What stands before the names of its cases in messages.
    pub(crate) prefix: String,
    pub(crate) folder: ResultsFolder,
    /// The keys that are varied.
    pub(crate) keys: Vec<String>,
    /// What the user asks to keep of each case.
    pub(crate) keep: Option<Keep>,
    /// What at least is read again.
    pub(crate) needs: Keep,
}

impl Set {
    /// What is kept of a case.
    pub(super) fn keep(&self, case: &Case, csv: bool) -> Keep {
        let keep = self.keep.unwrap_or_else(|| Keep::of_itself(case, csv));
        keep.max(self.needs)
    }
}
