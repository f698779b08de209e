//! The conclusion of a job: its counts, the reason why it is not complete, its errors.

use std::path::Path;

use wholestring_runner::{
    BatchOutcome,
    job::JobOutcome,
    run::{self, Stop},
    sweep,
};

use crate::{failure::Failure, terminal::print_stdout};

/// Prints the number finished of `items`, which together are a `noun`, as in the command.
///
/// # Errors
/// Some failed, or the user interrupted the batch.
pub(crate) fn conclude(
    outcome: &BatchOutcome,
    noun: &str,
    items: &str,
    quiet: bool,
) -> Result<(), Failure> {
    let place = outcome.folder.display();
    let (all, finished) = (outcome.all, outcome.finished);
    let items = if all == 1 { items.trim_end_matches('s') } else { items };
    if !quiet {
        let took_s = outcome.took.as_secs_f64();
        print_stdout(&format!(
            "{finished} of {all} {items} finished in {took_s:.1} s\nResults in {place}\n",
        ))?;
        let (known, of_all_shares) = outcome.known;
        if of_all_shares > all {
            print_stdout(&format!(
                "Tables and page have {known} of the {of_all_shares} {items} of all shares\n"
            ))?;
        }
    }
    let failed = outcome.failed.iter();
    let failed: Vec<String> =
        failed.map(|failed| format!("  {}: {}", failed.name, failed.reason)).collect();
    let failures = failed.join("\n");
    if outcome.is_interrupted() {
        let failures = if failed.is_empty() { failures } else { failures + "\n" };
        return Err(Failure::Interrupted(format!(
            "{failures}interrupted: partial results are in {place}\nto continue, run the {noun} \
             again with --resume"
        )));
    }
    if failed.is_empty() {
        return Ok(());
    }
    Err(Failure::Failed(format!(
        "error: {} of {all} {items} failed\n{failures}\npartial results are in {place}",
        failed.len(),
    )))
}

/// The failure of `--strict`, if there are errors.
///
/// # Errors
/// There are errors: their operations and labels.
pub(crate) fn refuse(errors: &[String]) -> Result<(), Failure> {
    match errors {
        [] => Ok(()),
        errors => Err(Failure::Refused(format!("error: errors were found: {}", errors.join("; ")))),
    }
}

/// Concludes a batch of cases: prints how many finished, and the cases with errors, which fail the
/// batch if `strict` is set. Cases that failed and cases with errors are both listed.
///
/// # Errors
/// Those of [`conclude`], and cases with errors if `strict` is set.
pub(crate) fn conclude_judged(
    outcome: &BatchOutcome,
    noun: &str,
    strict: bool,
    quiet: bool,
) -> Result<(), Failure> {
    let ended = conclude(outcome, noun, "cases", quiet);
    if let Err(Failure::Interrupted(_)) = ended {
        return ended;
    }
    match (ended, refuse_cases(outcome, strict, quiet)) {
        (Err(Failure::Failed(failed)), Err(refused)) => {
            Err(Failure::Failed(format!("{refused}\n{failed}")))
        }
        (ended, judged) => ended.and(judged),
    }
}

/// Prints the cases with errors, which fail the batch if `strict` is set.
fn refuse_cases(outcome: &BatchOutcome, strict: bool, quiet: bool) -> Result<(), Failure> {
    let (found, cases) = (outcome.with_errors.len(), outcome.all);
    if found == 0 {
        return Ok(());
    }
    if strict {
        let wrong = outcome.with_errors.iter();
        let wrong: Vec<String> =
            wrong.map(|row| format!("  {}: {}", row.name, row.operations.join(", "))).collect();
        return Err(Failure::Refused(format!(
            "error: errors were found in {found} of {cases} cases\n{}",
            wrong.join("\n")
        )));
    }
    if quiet {
        return Ok(());
    }
    let file = sweep::FILE;
    print_stdout(&format!("Errors were found in {found} of {cases} cases: see {file}\n"))
}

/// Fails if a job other than a batch is not complete.
///
/// # Errors
/// The reason why it is not, with the folder of its partial results.
pub(crate) fn unfinished(outcome: JobOutcome) -> Result<(), Failure> {
    match outcome {
        JobOutcome::Run(mut outcome) => match outcome.stopped.take() {
            Some(stop) => Err(stopped(stop, &outcome)),
            None => Ok(()),
        },
        JobOutcome::Reach(outcome) => unless_interrupted(outcome.interrupted, &outcome.folder),
        JobOutcome::Bha(outcome) => unless_interrupted(outcome.interrupted, &outcome.folder),
        JobOutcome::Modes(outcome) => unless_interrupted(outcome.interrupted, &outcome.folder),
        JobOutcome::Calibrate(outcome) if outcome.interrupted => {
            let place = outcome.folder.display();
            Err(Failure::Interrupted(format!(
                "interrupted: the calibration is in {place}, its check by the dynamics is not \
                 complete"
            )))
        }
        _ => Ok(()),
    }
}

/// The reason why the run did not finish, and the folder of its partial results.
fn stopped(stop: Stop, outcome: &run::Outcome) -> Failure {
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
fn unless_interrupted(interrupted: bool, folder: &Path) -> Result<(), Failure> {
    match interrupted {
        false => Ok(()),
        true => {
            let place = folder.display();
            Err(Failure::Interrupted(format!("interrupted: partial results are in {place}")))
        }
    }
}
