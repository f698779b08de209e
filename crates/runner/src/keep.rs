//! Files of a case that are kept on the disk.

use std::path::Path;

use serde::{Deserialize, Serialize};
use wholestring::outcome::{Cost, ModelKind};
use wholestring_case::Case;

/// Files of a case that are kept; each level includes those before it. Frames and spectra are
/// always kept if a case requires them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Keep {
    /// Its `summary.json`.
    Summary,
    /// Also its tables.
    Tables,
    /// All files of a run: also its page and its picture.
    All,
}

impl Keep {
    /// The level with this name.
    pub fn named(name: &str) -> Option<Self> {
        let levels = [("summary", Self::Summary), ("tables", Self::Tables), ("all", Self::All)];
        levels.into_iter().find(|level| level.0 == name).map(|level| level.1)
    }

    /// Default level for a case of a sweep: a soft string is solved again in milliseconds, a
    /// dynamic run is not.
    pub(crate) fn of_itself(case: &Case, csv: bool) -> Self {
        let costs = |kind: &ModelKind| kind.method().cost > Cost::Milliseconds;
        if csv || case.models.iter().any(costs) { Self::Tables } else { Self::Summary }
    }

    /// Whether a folder with a summary contains the tables of this level.
    pub(crate) fn has_tables(self, folder: &Path) -> bool {
        self == Self::Summary || folder.join("nodes.parquet").is_file()
    }
}
