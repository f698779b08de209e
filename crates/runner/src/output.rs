//! Where results go.

use std::path::PathBuf;

/// The folder for results, and what becomes of what lies there.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Output {
    /// The folder; where none is named, `out/<name>`, or the next one like it that does not hold
    /// other results.
    pub folder: Option<PathBuf>,
    /// Where `out` lies, where no folder is named; here by default.
    pub root: PathBuf,
    /// What becomes of what lies there.
    pub existing: Existing,
}

/// What becomes of what lies in a folder for results.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Existing {
    /// Finished results of the same work are replaced; with all others the work is refused.
    #[default]
    Protect,
    /// It is continued: what is finished is left out, what is not continues from its checkpoints.
    Resume,
    /// It is replaced, whatever it is of.
    Overwrite,
}
