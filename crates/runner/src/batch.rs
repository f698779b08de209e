//! Options and outcome shared by the cases of a sweep or study and the points of a bit test.

use std::{
    num::NonZeroUsize,
    path::{Path, PathBuf},
    time::Duration,
};

use crate::{
    cancellation::CancellationToken, clock::Instant, error::Error, output::Output, parallel::jobs,
    shard::Shard,
};

/// Options for solving a set of cases.
#[derive(Debug, Clone, Default)]
pub struct BatchOptions {
    /// Destination of the results.
    pub output: Output,
    /// Number of parallel jobs, a case each; one per core by default.
    pub jobs: Option<NonZeroUsize>,
    /// Share of the cases to solve.
    pub shard: Shard,
    /// Wall-clock time between checkpoints; by default that of the case.
    pub checkpoint_every: Option<Duration>,
    /// Whether to also write the tables that are kept as CSV.
    pub csv: bool,
}

impl BatchOptions {
    /// Number of parallel jobs, a case each.
    pub(crate) fn jobs(&self) -> usize {
        jobs(self.jobs)
    }
}

/// Outcome of a batch.
#[derive(Debug)]
#[must_use = "cases of a batch may have failed, or not have been solved"]
pub struct BatchOutcome {
    /// Folder of the results.
    pub folder: PathBuf,
    /// Number of cases or points in this share.
    pub all: usize,
    /// Number of them that are finished.
    pub finished: usize,
    /// Those that failed.
    pub failed: Vec<FailedCase>,
    /// Those whose answers have errors.
    pub with_errors: Vec<CaseWithErrors>,
    /// Number of cases or points of all shares that the tables contain, and their total number.
    pub known: (usize, usize),
    /// Whether the batch was cancelled.
    pub cancelled: bool,
    /// Wall-clock time.
    pub took: Duration,
}

/// A case that failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FailedCase {
    /// Name of its folder, relative to that of the batch.
    pub name: String,
    /// Reason of the failure.
    pub reason: String,
}

/// A case whose answers have errors.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseWithErrors {
    /// Name of its folder, relative to that of the batch.
    pub name: String,
    /// Operations that have errors, such as `trip in (soft)`.
    pub operations: Vec<String>,
}

impl BatchOutcome {
    /// Creates an outcome for this number of cases, none of which is counted yet.
    pub(crate) fn begin(
        folder: &Path,
        all: usize,
        since: Instant,
        token: &CancellationToken,
    ) -> Self {
        Self {
            folder: folder.to_owned(),
            all,
            finished: 0,
            failed: Vec::new(),
            with_errors: Vec::new(),
            known: (0, all),
            cancelled: token.is_cancelled(),
            took: since.elapsed(),
        }
    }

    /// Whether cases were left out because the batch was cancelled.
    pub fn is_interrupted(&self) -> bool {
        self.cancelled && self.finished + self.failed.len() < self.all
    }

    /// Returns the outcome of a batch whose cases are all finished.
    ///
    /// # Errors
    /// [`Error::Interrupted`] if cases were left out, [`Error::Failed`] if some failed.
    pub fn finished(self) -> Result<Self, Error> {
        if self.is_interrupted() {
            return Err(Error::Interrupted);
        }
        let reasons = self.failed.iter();
        let reasons: Vec<String> =
            reasons.map(|reason| format!("{}: {}", reason.name, reason.reason)).collect();
        match reasons.is_empty() {
            true => Ok(self),
            false => Err(Error::Failed(reasons.join("\n"))),
        }
    }
}
