//! Errors that prevent or end work.

use std::fmt;

use thiserror::Error as Explained;
use wholestring_case::Report;
use wholestring_contain::{Panicked, contain};
use wholestring_results::ResultsError;

use crate::claim::FolderRefused;

/// Reason why work was not begun or not finished.
///
/// Its text is one or more sentences without terms of any front end; the front end adds the advice
/// to the user.
#[derive(Debug, Explained)]
pub enum Error {
    /// Case files with mistakes, each with its position.
    #[error("{}", .0.render(false).trim_end())]
    Unsound(Unsound),

    /// Any other request that is not possible.
    #[error("{0}")]
    BadInput(String),

    /// The content of the folder cannot be continued.
    #[error("{reason}")]
    NotResumable {
        /// The item that would have to start again: `case`, `test`.
        noun: &'static str,
        /// The reason.
        reason: String,
    },

    /// The folder cannot be used.
    #[error(transparent)]
    Folder(#[from] FolderRefused),

    /// Results cannot be read or written.
    #[error(transparent)]
    Results(#[from] ResultsError),

    /// An operation, or cases of a batch, have no solution or diverged.
    #[error("{0}")]
    Failed(String),

    /// The [`CancellationToken`](crate::CancellationToken) was used.
    #[error("interrupted")]
    Interrupted,
}

impl Error {
    /// A request that is not possible, with its reason.
    pub(crate) fn bad_input(reason: impl fmt::Display) -> Self {
        Self::BadInput(reason.to_string())
    }

    /// Whether the request, or a file or folder that it names, is at fault; otherwise the work
    /// failed or was stopped.
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Unsound(_) | Self::BadInput(_) | Self::NotResumable { .. } | Self::Folder(_) => {
                true
            }
            Self::Results(error) => error.is_of_reading(),
            Self::Failed(_) | Self::Interrupted => false,
        }
    }

    /// A failure described completely by another error.
    pub(crate) fn failed(error: impl fmt::Display) -> Self {
        Self::Failed(error.to_string())
    }
}

/// Runs work on files that may be damaged, and converts panics into errors.
pub(crate) fn contained<T>(work: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    contain(work).unwrap_or_else(|Panicked(mistake)| Err(Error::failed(mistake_of(&mistake))))
}

/// Sentence that reports a panic.
pub(crate) fn mistake_of(mistake: &str) -> String {
    format!("a mistake of the program, please report it: {mistake}")
}

/// Mistakes in case files.
#[derive(Debug)]
pub struct Unsound {
    /// Some of the mistakes; equal ones are reported once.
    pub reports: Vec<Report>,
    /// Number of affected cases, if there are several.
    pub summary: Option<String>,
}

impl Unsound {
    /// Renders the mistakes underlined in their files, with colours for a terminal if requested.
    pub fn render(&self, color: bool) -> String {
        let reports = self.reports.iter().map(|report| report.render(color));
        let lines = reports.chain(self.summary.clone());
        lines.collect::<Vec<_>>().join("\n")
    }
}

impl From<Report> for Error {
    fn from(report: Report) -> Self {
        Self::Unsound(Unsound { reports: vec![report], summary: None })
    }
}
