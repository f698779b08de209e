//! What all cases of a sweep or a study, and all points of a bit test, have in common.

use std::{
    num::NonZeroUsize,
    path::{Path, PathBuf},
    time::Duration,
};

use crate::{
    cancellation::CancellationToken, clock::Instant, error::Error, output::Output, parallel::jobs,
    shard::Shard,
};

/// How many cases are solved.
#[derive(Debug, Clone, Default)]
pub struct BatchOptions {
    /// Where results go.
    pub output: Output,
    /// Number of parallel jobs, a case each; one per core by default.
    pub jobs: Option<NonZeroUsize>,
    /// The share of the cases that is solved.
    pub shard: Shard,
    /// Wall-clock time between checkpoints; the case's by default.
    pub checkpoint_every: Option<Duration>,
    /// Whether to write the tables that are kept as CSV too.
    pub csv: bool,
}

impl BatchOptions {
    /// Number of parallel jobs, a case each.
    pub(crate) fn jobs(&self) -> usize {
        jobs(self.jobs)
    }
}

/// How a batch ended.
#[derive(Debug)]
#[must_use = "cases of a batch may have failed, or not have been solved"]
pub struct BatchOutcome {
    /// Where the results are.
    pub folder: PathBuf,
    /// Cases or points of this share.
    pub all: usize,
    /// Those of them that are finished.
    pub finished: usize,
    /// Those of them that failed.
    pub failed: Vec<FailedCase>,
    /// Those of them in whose answers errors were found.
    pub with_errors: Vec<CaseWithErrors>,
    /// Cases or points of all shares that the tables have, and how many there are in all.
    pub known: (usize, usize),
    /// Whether it was cancelled.
    pub cancelled: bool,
    /// Wall-clock time.
    pub took: Duration,
}

/// A case that failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FailedCase {
    /// Name of its folder, as seen from the batch's.
    pub name: String,
    /// Why it failed.
    pub reason: String,
}

/// A case in whose answers errors were found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CaseWithErrors {
    /// Name of its folder, as seen from the batch's.
    pub name: String,
    /// The operations that have errors: `trip in (soft)`.
    pub operations: Vec<String>,
}

impl BatchOutcome {
    /// Of so many cases, none of which has been counted yet.
    pub(crate) fn begin(folder: &Path, all: usize, since: Instant, of: &CancellationToken) -> Self {
        Self {
            folder: folder.to_owned(),
            all,
            finished: 0,
            failed: Vec::new(),
            with_errors: Vec::new(),
            known: (0, all),
            cancelled: of.is_cancelled(),
            took: since.elapsed(),
        }
    }

    /// Whether cases were left out because it was cancelled.
    pub fn is_interrupted(&self) -> bool {
        self.cancelled && self.finished + self.failed.len() < self.all
    }

    /// The outcome of a batch whose cases are all finished.
    ///
    /// # Errors
    /// [`Error::Interrupted`] where cases were left out, [`Error::Failed`] where some failed.
    pub fn finished(self) -> Result<Self, Error> {
        if self.is_interrupted() {
            return Err(Error::Interrupted);
        }
        let reasons = self.failed.iter();
        let reasons: Vec<String> =
            reasons.map(|of| format!("{}: {}", of.name, of.reason)).collect();
        match reasons.is_empty() {
            true => Ok(self),
            false => Err(Error::Failed(reasons.join("\n"))),
        }
    }
}
