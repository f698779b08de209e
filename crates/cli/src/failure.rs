//! Why a command failed, and the exit status that says so.

use std::fmt;

use wholestring_results::ResultsError;

/// A command that did not end well.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The input is not sound: what, where, what was expected.
    BadInput(String),
    /// The run could not be finished.
    Failed(String),
    /// An error was found in an answer, and `--strict` lets none pass.
    Refused(String),
    /// The user stopped it.
    Interrupted(String),
}

impl Failure {
    /// The exit status of the program.
    pub(crate) fn status(&self) -> u8 {
        match self {
            Self::BadInput(_) => 2,
            Self::Failed(_) => 3,
            Self::Refused(_) => 4,
            Self::Interrupted(_) => 130,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadInput(text)
            | Self::Failed(text)
            | Self::Refused(text)
            | Self::Interrupted(text) => {
                write!(to, "{}", text.trim_end())
            }
        }
    }
}

impl From<ResultsError> for Failure {
    fn from(error: ResultsError) -> Self {
        Self::Failed(format!("error: {error}"))
    }
}
