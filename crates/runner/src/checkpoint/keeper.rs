//! Checkpoints as time goes by.

use std::time::{Duration, Instant};

use serde::Serialize;
use wholestring_results::{ResultsError, ResultsFolder};

/// Writes checkpoints of a run as time goes by.
pub(crate) struct Keeper<'a> {
    folder: &'a ResultsFolder,
    every: Duration,
    last: Instant,
}

impl<'a> Keeper<'a> {
    /// A keeper that writes to the folder after each such while.
    pub(crate) fn new(folder: &'a ResultsFolder, every: Duration) -> Self {
        Self { folder, every, last: Instant::now() }
    }

    /// Whether the time for a checkpoint has come.
    pub(crate) fn is_due(&self) -> bool {
        self.last.elapsed() >= self.every
    }

    /// Writes what is needed to continue.
    pub(crate) fn write(&mut self, content: &impl Serialize) -> Result<(), ResultsError> {
        let written = self.folder.write_checkpoint(content);
        self.last = Instant::now();
        written
    }

    /// The run has come to its end: there is nothing to continue with.
    pub(crate) fn finish(self) -> Result<(), ResultsError> {
        self.folder.remove_checkpoint()
    }
}
