//! Reasons why a case was not solved to its end.

use std::fmt;

use wholestring_results::ResultsError;

use crate::error::Error;

/// Reason why a case was not solved to its end.
#[derive(Debug)]
pub enum Stop {
    /// It was cancelled.
    Interrupted,
    /// An operation without a solution or one that diverged, with the reason.
    Unsolved(String),
    /// The results could not be written.
    Unwritten(Error),
}

impl Stop {
    /// Reason why the case failed; `None` if it was cancelled.
    pub fn reason(&self) -> Option<String> {
        match self {
            Self::Interrupted => None,
            Self::Unsolved(_) | Self::Unwritten(_) => Some(self.to_string()),
        }
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interrupted => write!(to, "interrupted"),
            Self::Unsolved(reason) => write!(to, "{reason}"),
            Self::Unwritten(error) => write!(to, "{error}"),
        }
    }
}

impl From<Error> for Stop {
    fn from(error: Error) -> Self {
        Self::Unwritten(error)
    }
}

impl From<ResultsError> for Stop {
    fn from(error: ResultsError) -> Self {
        Self::Unwritten(error.into())
    }
}

impl From<Stop> for Error {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Interrupted => Self::Interrupted,
            Stop::Unsolved(reason) => Self::Failed(reason),
            Stop::Unwritten(error) => error,
        }
    }
}
