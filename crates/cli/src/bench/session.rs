//! How measurements are taken, and shown while they are.

use indicatif::ProgressBar;
use wholestring_runner::CancellationToken;

use super::{clock::Spread, well::Well};
use crate::{failure::Failure, terminal::print_stdout};

/// How the measurements are taken.
pub(super) struct Bench {
    pub(super) well: Well,
    /// How often each is repeated.
    pub(super) count: usize,
    pub(super) cancellation: CancellationToken,
    pub(super) bar: ProgressBar,
}

impl Bench {
    pub(super) fn print(&self, text: &str) -> Result<(), Failure> {
        self.bar.suspend(|| print_stdout(&format!("{text}\n")))
    }

    /// Begins to measure `count` things.
    pub(super) fn begin(&self, count: usize) {
        self.bar.set_position(0);
        self.bar.set_length(count as u64);
    }

    /// Shows what is measured next, unless the user asked to stop.
    pub(super) fn next(&self, what: &str) -> Result<(), Failure> {
        self.bar.set_message(what.to_owned());
        self.bar.inc(1);
        if self.cancellation.is_cancelled() {
            return Err(Failure::Interrupted("interrupted".to_owned()));
        }
        Ok(())
    }

    /// Repeats a measurement.
    pub(super) fn repeat(
        &self,
        mut measure: impl FnMut() -> Result<f64, Failure>,
    ) -> Result<Spread, Failure> {
        let mut found = Vec::new();
        for _ in 0..self.count {
            found.push(measure()?);
        }
        Ok(Spread::of(found))
    }
}
