//! One case of a sweep, solved into its folder.

use std::{path::Path, time::Duration};

use wholestring_case::Case;
use wholestring_results::{OperationSummary, ResultsFolder, Status, Summary};

use super::ending::Ending;
use crate::{
    cancellation::CancellationToken,
    checkpoint::{RunCheckpoint, UnderWay, is_of},
    cores,
    keep::Keep,
    observer::Watch,
    output::Existing,
    page,
    record::Record,
    run::{Stop, Way, checkpoint_every, solve},
};

/// One case of a sweep.
pub(crate) struct OneCase<'a> {
    pub(crate) case: &'a Case,
    /// Name of the case in messages.
    pub(crate) label: &'a str,
    /// Simulated time of its dynamic runs, s; an upper limit.
    pub(crate) simulated_s: f64,
    pub(crate) keep: Keep,
    pub(crate) csv: bool,
    pub(crate) existing: Existing,
    /// Wall-clock time between checkpoints; by default that of the case.
    pub(crate) checkpoint_every: Option<Duration>,
    pub(crate) watch: Watch<'a>,
    pub(crate) cancellation: &'a CancellationToken,
}

impl OneCase<'_> {
    /// Solves it into the folder, or uses the results of an earlier sweep there if the sweep is
    /// resumed.
    pub(crate) fn solve(&self, folder: &ResultsFolder) -> Result<Ending, Stop> {
        let (case, keep) = (self.case, self.keep);
        let mut begun = None;
        if self.existing == Existing::Resume {
            match finished(folder.path(), case, keep) {
                Ok(Some(solved)) => {
                    // A run that was killed between its last result and its end may leave one.
                    folder.remove_checkpoint()?;
                    if keep == Keep::All {
                        page::complete(folder, case.units)?;
                    }
                    return Ok(Ending { solved, why: None, reused_s: self.simulated_s });
                }
                Ok(None) => begun = self.begun(folder),
                Err(reason) => self.warn(&reason),
            }
        }
        let (mut record, under_way) = match begun {
            Some(begun) => begun,
            None => (Record::begin(case, case.units, folder)?, None),
        };
        let way = Way {
            keep,
            csv: self.csv,
            checkpoint_every: self.checkpoint_every.unwrap_or_else(|| checkpoint_every(case)),
            watch: self.watch,
            cancellation: self.cancellation,
            // The cores are used for different cases.
            executor: cores::alone(self.cancellation),
        };
        let why = solve(case, &way, &mut record, Some(folder), under_way).err();
        if keep == Keep::All {
            page::write(folder, case.units)?;
        }
        Ok(Ending { solved: record.into_summary().operations, why, reused_s: 0.0 })
    }

    /// Unfinished run of the case from an earlier sweep; `None` if there is none that can be
    /// continued.
    fn begun(&self, folder: &ResultsFolder) -> Option<(Record, Option<UnderWay<'static>>)> {
        let case = self.case;
        let begun = RunCheckpoint::<'static>::read(folder, case).and_then(|stored| {
            let Some(stored) = stored else {
                return Ok(None);
            };
            let record = Record::resume(case, case.units, folder, stored.solved)?;
            Ok(Some((record, stored.under_way)))
        });
        begun.unwrap_or_else(|reason| {
            self.warn(&reason);
            None
        })
    }

    /// Warns that it does not continue from the files in its folder, with the reason.
    fn warn(&self, reason: &str) {
        let warning = format!("{}: {reason}; it starts again", self.label);
        self.watch.observer.warning(&warning);
    }
}

/// Results of a finished run of the case in the folder; `None` if there is none, it is not
/// finished, or it lacks files that are to be kept.
///
/// # Errors
/// The reason why the files there do not belong to the case.
fn finished(
    folder: &Path,
    case: &Case,
    keep: Keep,
) -> Result<Option<Vec<OperationSummary>>, String> {
    let Ok(summary) = Summary::read(&folder.join("summary.json")) else {
        return Ok(None);
    };
    is_of(&summary, case)?;
    let all = case.operations.len() * case.models.len();
    let complete = is_complete(&summary, all) && keep.has_tables(folder);
    Ok(complete.then_some(summary.operations))
}

/// Whether a summary contains this number of answers, all of them complete.
pub(super) fn is_complete(summary: &Summary, answers: usize) -> bool {
    summary.operations.len() == answers
        && summary.operations.iter().all(|operation| operation.status == Status::Complete)
}
