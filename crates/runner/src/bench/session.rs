//! How measurements are taken, and watched while they are.

use std::path::PathBuf;

use wholestring_case::Override;

use super::{
    clock::Spread,
    well::{MeasuredWell, Well},
};
use crate::{CancellationToken, Error};

/// Learns what is measured: a progress bar.
pub trait Watcher {
    /// So many things begin to be measured.
    fn begun(&self, _count: usize) {}

    /// This is measured next.
    fn next(&self, _what: &str) {}
}

/// Measures one part after the other.
pub struct Bench<'a> {
    pub(super) well: Well,
    /// How often each measurement is repeated.
    count: usize,
    /// The `wholestring` command, which solves what is measured as a process of its own.
    pub(super) program: PathBuf,
    watcher: &'a dyn Watcher,
    cancellation: CancellationToken,
}

impl<'a> Bench<'a> {
    /// Measures NP13-X1042 with these keys set, each number the median of `count`; memory and
    /// sweeps
    /// are those of `program`, a `wholestring` command.
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

    /// The well that is measured.
    ///
    /// # Errors
    /// The overrides do not fit the case.
    pub fn well(&self) -> Result<MeasuredWell, Error> {
        self.well.about()
    }

    /// Begins to measure `count` things.
    pub(super) fn begin(&self, count: usize) {
        self.watcher.begun(count);
    }

    /// Says what is measured next, unless the user asked to stop.
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
