//! Why work is not taken on.

use wholestring_case::Report;

use crate::workspace::WorkspaceError;

/// Why work is not taken on.
#[derive(Debug, thiserror::Error)]
pub(crate) enum JobError {
    /// The case, or the study, is invalid.
    #[error("the case is not valid")]
    Unsound(Report),
    /// What is asked cannot be so.
    #[error("{0}")]
    BadInput(String),
    /// It cannot be so now.
    #[error("{0}")]
    Conflict(String),
    /// The folder refuses.
    #[error(transparent)]
    Workspace(#[from] WorkspaceError),
}

impl From<Report> for JobError {
    fn from(report: Report) -> Self {
        Self::Unsound(report)
    }
}
