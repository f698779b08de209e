//! Cases with a folder and a table of their own.

use wholestring_case::Case;
use wholestring_results::ResultsFolder;

use crate::keep::Keep;

/// Cases with a folder and a table of their own.
pub(crate) struct Set {
    /// Prefix of the names of its cases in messages.
    pub(crate) prefix: String,
    pub(crate) folder: ResultsFolder,
    /// Varied keys.
    pub(crate) keys: Vec<String>,
    /// Files of each case that the user requests to keep.
    pub(crate) keep: Option<Keep>,
    /// Files that are read again and so are always kept.
    pub(crate) needs: Keep,
}

impl Set {
    /// Files of a case that are kept.
    pub(super) fn keep(&self, case: &Case, csv: bool) -> Keep {
        let keep = self.keep.unwrap_or_else(|| Keep::of_itself(case, csv));
        keep.max(self.needs)
    }
}
