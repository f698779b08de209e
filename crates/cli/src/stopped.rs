//! A run that did not come to its end.

use std::path::Path;

use wholestring_runner::run::{Outcome, Stop};

use crate::failure::Failure;

/// Why the run did not come to its end, and where what it computed lies.
pub(crate) fn stopped(stop: Stop, outcome: &Outcome) -> Failure {
    let place = outcome.folder.display();
    match stop {
        Stop::Interrupted => {
            let how = if outcome.is_resumable {
                format!("\nto continue, run the case with --resume {place}")
            } else {
                String::new()
            };
            Failure::Interrupted(format!("interrupted: what was computed is in {place}{how}"))
        }
        Stop::Unsolved(reason) => {
            Failure::Failed(format!("error: {reason}\nwhat was computed is in {place}"))
        }
        Stop::Unwritten(error) => error.into(),
    }
}

/// Says where the results are that are not whole.
///
/// # Errors
/// The work was interrupted.
pub(crate) fn unless_interrupted(interrupted: bool, folder: &Path) -> Result<(), Failure> {
    match interrupted {
        false => Ok(()),
        true => {
            let place = folder.display();
            Err(Failure::Interrupted(format!("interrupted: what was computed is in {place}")))
        }
    }
}
