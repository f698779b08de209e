//! Repetition of measurements, and reports of their progress.

use std::path::PathBuf;

use wholestring_case::Override;

use super::{
    clock::Spread,
    well::{MeasuredWell, Well},
};
use crate::{CancellationToken, Error};

/// Receives the progress of the measurements, for a progress bar.
pub trait Watcher {
    /// The measurement of `_count` items begins.
    fn begun(&self, _count: usize) {}

    /// The next item begins.
    fn next(&self, _what: &str) {}
}

/// Runs the measurements one after the other.
pub struct Bench<'a> {
    pub(super) well: Well,
    /// Number of repetitions of each measurement.
    count: usize,
    /// The `wholestring` command, which solves the case in a process of its own.
    pub(super) program: PathBuf,
    watcher: &'a dyn Watcher,
    cancellation: CancellationToken,
}

impl<'a> Bench<'a> {
    /// Measures NP13-X1042 with these keys set, each number the median of `count`; memory and
    /// sweeps are measured on `program`, a `wholestring` command.
    ///
    /// # Errors
    /// The case cannot be written to a temporary folder.
    pub fn new(
        overrides: &[Override],
        count: usize,
        program: PathBuf,
        watcher: &'a dyn Watcher,
        cancellation: CancellationToken,
    ) -> Result<Self, Error> {
        Ok(Self { well: Well::new(overrides)?, count, program, watcher, cancellation })
    }

    /// Returns the well that is measured.
    ///
    /// # Errors
    /// The overrides do not fit the case.
    pub fn well(&self) -> Result<MeasuredWell, Error> {
        self.well.about()
    }

    /// Starts the measurement of `count` items.
    pub(super) fn begin(&self, count: usize) {
        self.watcher.begun(count);
    }

    /// Reports the next item, unless the user requested to stop.
    pub(super) fn next(&self, what: &str) -> Result<(), Error> {
        self.watcher.next(what);
        match self.cancellation.is_cancelled() {
            true => Err(Error::Interrupted),
            false => Ok(()),
        }
    }

    /// Repeats a measurement.
    pub(super) fn repeat(
        &self,
        mut measure: impl FnMut() -> Result<f64, Error>,
    ) -> Result<Spread, Error> {
        let mut found = Vec::new();
        for _ in 0..self.count {
            found.push(measure()?);
        }
        Ok(Spread::of(found))
    }
}
