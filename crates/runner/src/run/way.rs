//! Options for solving a case, and reasons why it was not solved to its end.

use std::{fmt, time::Duration};

use wholestring_case::Case;
use wholestring_results::ResultsError;

use crate::{
    cancellation::CancellationToken, cores::SharedExecutor, error::Error, keep::Keep,
    observer::Watch,
};

/// Options for solving a case, in addition to its settings.
pub(crate) struct Way<'a> {
    /// Files that are kept.
    pub(crate) keep: Keep,
    /// Whether to also write the tables as CSV.
    pub(crate) csv: bool,
    /// Wall-clock time between checkpoints.
    pub(crate) checkpoint_every: Duration,
    /// Observer of its progress.
    pub(crate) watch: Watch<'a>,
    pub(crate) cancellation: &'a CancellationToken,
    /// Executor for solid rock.
    pub(crate) executor: SharedExecutor,
}

/// Wall-clock time between checkpoints in the case's settings.
pub(crate) fn checkpoint_every(case: &Case) -> Duration {
    Duration::from_secs_f64(case.checkpoint_interval_s)
}

// Reasons why a case was not solved to its end.

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
