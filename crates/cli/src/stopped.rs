//! A run that did not finish.

use std::path::Path;

use wholestring_runner::run::{Outcome, Stop};

use crate::failure::Failure;

/// The reason why the run did not finish, and the folder of its partial results.
pub(crate) fn stopped(stop: Stop, outcome: &Outcome) -> Failure {
    let place = outcome.folder.display();
    match stop {
        Stop::Interrupted => {
            let how = if outcome.is_resumable {
                format!("\nto continue, run the case with --resume {place}")
            } else {
                String::new()
            };
            Failure::Interrupted(format!("interrupted: partial results are in {place}{how}"))
        }
        Stop::Unsolved(reason) => {
            Failure::Failed(format!("error: {reason}\npartial results are in {place}"))
        }
        Stop::Unwritten(error) => error.into(),
    }
}

/// Reports the folder of the incomplete results.
///
/// # Errors
/// The work was interrupted.
pub(crate) fn unless_interrupted(interrupted: bool, folder: &Path) -> Result<(), Failure> {
    match interrupted {
        false => Ok(()),
        true => {
            let place = folder.display();
            Err(Failure::Interrupted(format!("interrupted: partial results are in {place}")))
        }
    }
}
