//! Why work was not done.

use std::fmt;

use thiserror::Error as Explained;
use wholestring_case::Report;
use wholestring_contain::{Panicked, contain};
use wholestring_results::ResultsError;

use crate::claim::FolderRefused;

/// Why work was not begun, or not brought to its end.
///
/// Its text is one sentence or more, without a word of any front; what a user can do about it, the
/// front adds.
#[derive(Debug, Explained)]
pub enum Error {
    /// Case files with mistakes, each with its place.
    #[error("{}", .0.render(false).trim_end())]
    Unsound(Unsound),

    /// Something else that was requested is not possible.
    #[error("{0}")]
    BadInput(String),

    /// What lies in the folder cannot be continued.
    #[error("{reason}")]
    NotResumable {
        /// What would have to begin anew: `case`, `test`.
        noun: &'static str,
        /// Why not.
        reason: String,
    },

    /// The folder is not to be written to.
    #[error(transparent)]
    Folder(#[from] FolderRefused),

    /// Results cannot be read or written.
    #[error(transparent)]
    Results(#[from] ResultsError),

    /// An operation has no answer or diverged, or cases of a batch have.
    #[error("{0}")]
    Failed(String),

    /// The [`CancellationToken`](crate::CancellationToken) was used.
    #[error("interrupted")]
    Interrupted,
}

impl Error {
    /// What was requested is not possible, for this reason.
    pub(crate) fn bad_input(reason: impl fmt::Display) -> Self {
        Self::BadInput(reason.to_string())
    }

    /// A failure that another error says all of.
    pub(crate) fn failed(error: impl fmt::Display) -> Self {
        Self::Failed(error.to_string())
    }
}

/// Work on files that may be damaged: a mistake of the program in it is an error like others.
pub(crate) fn contained<T>(work: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    contain(work).unwrap_or_else(|Panicked(mistake)| Err(Error::failed(mistake_of(&mistake))))
}

/// A sentence about a mistake of the program.
pub(crate) fn mistake_of(mistake: &str) -> String {
    format!("a mistake of the program, please report it: {mistake}")
}

/// Mistakes in case files.
#[derive(Debug)]
pub struct Unsound {
    /// Some of them; the same is reported once.
    pub reports: Vec<Report>,
    /// How many cases are concerned, where there are several.
    pub summary: Option<String>,
}

impl Unsound {
    /// The mistakes underlined in their files, coloured for a terminal if that is requested.
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
