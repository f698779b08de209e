//! How a case is solved, beside what it says itself.

use std::time::Duration;

use wholestring_case::Case;

use crate::{cancellation::CancellationToken, cores::SharedExecutor, keep::Keep, observer::Watch};

/// How a case is solved, beside what it says itself.
pub(crate) struct Way<'a> {
    /// What is kept of it.
    pub(crate) keep: Keep,
    /// Whether to write the tables as CSV too.
    pub(crate) csv: bool,
    /// Wall-clock time between checkpoints.
    pub(crate) checkpoint_every: Duration,
    /// Who watches its progress.
    pub(crate) watch: Watch<'a>,
    pub(crate) cancellation: &'a CancellationToken,
    /// Who works on solid rock.
    pub(crate) executor: SharedExecutor,
}

/// What the case says about the time between checkpoints.
pub(crate) fn checkpoint_every(case: &Case) -> Duration {
    Duration::from_secs_f64(case.checkpoint_interval_s)
}
