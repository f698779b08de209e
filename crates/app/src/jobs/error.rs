//! Reasons why work is refused.

use wholestring_case::Report;
use wholestring_runner::Error;

use crate::workspace::WorkspaceError;

/// Reason why work is refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum JobError {
    /// The case, or the study, is invalid.
    #[error("the case is not valid")]
    Unsound(Report),
    /// The request is invalid.
    #[error("{0}")]
    BadInput(String),
    /// The request is not possible at present.
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

impl From<Error> for JobError {
    fn from(error: Error) -> Self {
        match error {
            Error::Unsound(mut unsound) if unsound.reports.len() == 1 => {
                Self::Unsound(unsound.reports.remove(0))
            }
            error => Self::BadInput(error.to_string()),
        }
    }
}
