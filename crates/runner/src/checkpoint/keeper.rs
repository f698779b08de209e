//! Checkpoints at intervals of wall-clock time.

use std::time::Duration;

use serde::Serialize;
use wholestring_results::{ResultsError, ResultsFolder};

use crate::clock::Instant;

/// Writes checkpoints of a run at intervals of wall-clock time.
pub(crate) struct Keeper<'a> {
    /// `None` for a run in memory.
    folder: Option<&'a ResultsFolder>,
    every: Duration,
    last: Instant,
}

impl<'a> Keeper<'a> {
    /// Creates a writer of checkpoints in the folder with this interval.
    pub(crate) fn new(folder: &'a ResultsFolder, every: Duration) -> Self {
        Self { folder: Some(folder), every, last: Instant::now() }
    }

    /// Creates one that writes nothing, for a run in memory.
    pub(crate) fn in_memory() -> Self {
        Self { folder: None, every: Duration::MAX, last: Instant::now() }
    }

    /// Folder of the checkpoints; `None` for a run in memory.
    pub(crate) fn folder(&self) -> Option<&'a ResultsFolder> {
        self.folder
    }

    /// Whether the next checkpoint is due.
    pub(crate) fn is_due(&self) -> bool {
        self.folder.is_some() && self.last.elapsed() >= self.every
    }

    /// Writes a checkpoint.
    pub(crate) fn write(&mut self, content: &impl Serialize) -> Result<(), ResultsError> {
        let written = self.folder.map_or(Ok(()), |folder| folder.write_checkpoint(content));
        self.last = Instant::now();
        written
    }

    /// Removes the checkpoint of a run that is finished.
    pub(crate) fn finish(self) -> Result<(), ResultsError> {
        self.folder.map_or(Ok(()), ResultsFolder::remove_checkpoint)
    }
}
