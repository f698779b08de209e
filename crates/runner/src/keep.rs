//! What is kept of a case on the disk.

use std::path::Path;

use wholestring::outcome::{Cost, ModelKind};
use wholestring_case::Case;

/// What is kept of a case, each with what stands before it. Frames and spectra are kept wherever a
/// case requires them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Keep {
    /// Its `summary.json`.
    Summary,
    /// Its tables too.
    Tables,
    /// All that a run leaves: its page and its picture too.
    All,
}

impl Keep {
    /// What is kept of a case of a sweep where nobody says: a soft string is solved again in
    /// milliseconds, what dynamics found is not.
    pub(crate) fn of_itself(case: &Case, csv: bool) -> Self {
        let costs = |of: &ModelKind| of.method().cost > Cost::Milliseconds;
        if csv || case.models.iter().any(costs) { Self::Tables } else { Self::Summary }
    }

    /// Whether a folder with a summary holds the tables that are to be kept beside it.
    pub(crate) fn has_tables(self, folder: &Path) -> bool {
        self == Self::Summary || folder.join("nodes.parquet").is_file()
    }
}
