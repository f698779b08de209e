//! The conclusion of a batch of cases or points.

use wholestring_results::{Check, Severity};
use wholestring_runner::{BatchOutcome, sweep};

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

/// Fails with the status of `--strict` if a check is an error.
///
/// # Errors
/// `strict` is set and some check is an error: names and labels of those.
pub(crate) fn refuse_errors<'a>(
    strict: bool,
    checks: impl Iterator<Item = (String, &'a Check)>,
) -> Result<(), Failure> {
    let errors = checks.filter(|(_, check)| strict && check.severity == Severity::Error);
    let mut errors: Vec<String> = errors
        .map(|(name, check)| match name.is_empty() {
            true => check.kind.label().to_lowercase(),
            false => format!("{name}: {}", check.kind.label().to_lowercase()),
        })
        .collect();
    errors.dedup();
    match errors.is_empty() {
        true => Ok(()),
        false => Err(Failure::Refused(format!("error: errors were found: {}", errors.join("; ")))),
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
    match (ended, judge(outcome, strict, quiet)) {
        (Err(Failure::Failed(failed)), Err(refused)) => {
            Err(Failure::Failed(format!("{refused}\n{failed}")))
        }
        (ended, judged) => ended.and(judged),
    }
}

/// Prints the cases with errors, which fail the batch if `strict` is set.
fn judge(outcome: &BatchOutcome, strict: bool, quiet: bool) -> Result<(), Failure> {
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
