//! What is told at the end of many cases or points.

use std::{path::Path, time::Duration};

use crate::{failure::Failure, say};

/// How many of them were finished, and why the others were not.
pub(crate) struct Conclusion<'a> {
    /// What they are together, as in the command: `sweep`.
    pub(crate) noun: &'static str,
    /// What they are one by one: `cases`.
    pub(crate) items: &'static str,
    pub(crate) all: usize,
    pub(crate) finished: usize,
    /// A line for each that failed.
    pub(crate) failed: Vec<String>,
    /// Whether the user asked to stop.
    pub(crate) interrupted: bool,
    /// Where the results are.
    pub(crate) place: &'a Path,
    pub(crate) took: Duration,
}

impl Conclusion<'_> {
    /// Says how it went.
    ///
    /// # Errors
    /// Some failed, or the user stopped it.
    pub(crate) fn tell(self, quiet: bool) -> Result<(), Failure> {
        let Self {
            noun,
            items,
            all,
            finished,
            failed,
            interrupted,
            place,
            took,
        } = self;
        let place = place.display();
        if !quiet {
            let took_s = took.as_secs_f64();
            say(&format!(
                "{finished} of {all} {items} finished in {took_s:.1} s\nResults in {place}\n",
            ))?;
        }
        let failures = failed.join("\n");
        if interrupted && finished + failed.len() < all {
            let failures = if failed.is_empty() {
                failures
            } else {
                failures + "\n"
            };
            return Err(Failure::Interrupted(format!(
                "{failures}interrupted: what was computed is in {place}\nto go on, run the {noun} again with --resume"
            )));
        }
        if failed.is_empty() {
            return Ok(());
        }
        Err(Failure::Failed(format!(
            "error: {} of {all} {items} failed\n{failures}\nwhat was computed is in {place}",
            failed.len(),
        )))
    }
}
