//! Destination of results.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// Folder for results, and treatment of existing files there.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Output {
    /// The folder; `None` selects `out/<name>`, or the next numbered one without other results.
    pub folder: Option<PathBuf>,
    /// Parent of `out` if no folder is given; the current folder by default.
    pub root: PathBuf,
    /// Treatment of existing results.
    pub existing: Existing,
}

/// Treatment of existing results in a folder.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum Existing {
    /// Finished results of the same work are replaced; any others are refused.
    #[default]
    Protect,
    /// The work is continued: finished parts are skipped, the others resume from their checkpoints.
    Resume,
    /// Any results are replaced.
    Overwrite,
}
