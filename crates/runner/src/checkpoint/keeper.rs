//! Checkpoints as time goes by.

use std::time::Duration;

use serde::Serialize;
use wholestring_results::{ResultsError, ResultsFolder};

use crate::clock::Instant;

/// Writes checkpoints of a run as time goes by.
pub(crate) struct Keeper<'a> {
    /// Nothing for a run that stays in memory.
    folder: Option<&'a ResultsFolder>,
    every: Duration,
    last: Instant,
}

impl<'a> Keeper<'a> {
    /// A keeper that writes to the folder after each such while.
    pub(crate) fn new(folder: &'a ResultsFolder, every: Duration) -> Self {
        Self { folder: Some(folder), every, last: Instant::now() }
    }

    /// One that writes nothing: of a run that stays in memory.
    pub(crate) fn in_memory() -> Self {
        Self { folder: None, every: Duration::MAX, last: Instant::now() }
    }

    /// The folder that it writes to; none where the run stays in memory.
    pub(crate) fn folder(&self) -> Option<&'a ResultsFolder> {
        self.folder
    }

    /// Whether the time for a checkpoint has come.
    pub(crate) fn is_due(&self) -> bool {
        self.folder.is_some() && self.last.elapsed() >= self.every
    }

    /// Writes what is needed to continue.
    pub(crate) fn write(&mut self, content: &impl Serialize) -> Result<(), ResultsError> {
        let written = self.folder.map_or(Ok(()), |folder| folder.write_checkpoint(content));
        self.last = Instant::now();
        written
    }

    /// The run has come to its end: there is nothing to continue with.
    pub(crate) fn finish(self) -> Result<(), ResultsError> {
        self.folder.map_or(Ok(()), ResultsFolder::remove_checkpoint)
    }
}
