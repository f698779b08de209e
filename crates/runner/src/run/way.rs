//! Options for solving a case, in addition to its settings.

use std::time::Duration;

use wholestring_case::Case;

use crate::{cancellation::CancellationToken, cores::SharedExecutor, keep::Keep, observer::Watch};

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
