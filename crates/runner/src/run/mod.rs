//! A run: a case with all of its operations and models, solved one after the other.

mod answers;
mod live;
mod own_laws;
pub(crate) mod pictures;
mod sampled_law;
mod solve;
mod way;

pub use answers::{Answers, Solved, answer};
pub use live::Live;
pub use own_laws::OwnLaws;
pub use sampled_law::{Answering, BitAnswer, BitReading, SampledLaw, ShakeReading};
pub(crate) use solve::solve;
pub use way::Stop;
pub(crate) use way::{Way, checkpoint_every};

use std::{
    num::NonZeroUsize,
    path::{Path, PathBuf},
    time::Duration,
};

use wholestring_case::Case;
use wholestring_results::{Occupant, ResultsFolder, Status, Summary, digest};
use wholestring_units::UnitSet;

use crate::{
    cancellation::CancellationToken,
    checkpoint::{RunCheckpoint, UnderWay, is_of},
    claim::{self, Claim, Claimed},
    cores,
    error::Error,
    folder_name::default_output,
    keep::Keep,
    observer::{Observer, Watch},
    output::{Existing, Output},
    page,
    record::Record,
};

// Request of a run, and its outcome.

/// Request to solve a case.
#[derive(Debug, Clone)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// Destination of the results. With [`Existing::Resume`] the run in the folder continues from
    /// its checkpoint.
    pub output: Output,
    /// Units of the checks, the picture and the page; by default those of the case.
    pub units: Option<UnitSet>,
    /// Threads that work on solid rock under the bit, without effect on the answer; one per core by
    /// default.
    pub jobs: Option<NonZeroUsize>,
    /// Wall-clock time between checkpoints; by default that of the case.
    pub checkpoint_every: Option<Duration>,
    /// Whether to also write the tables as CSV.
    pub csv: bool,
}

impl<'a> Request<'a> {
    /// Request with default options.
    pub fn new(case: &'a Case) -> Self {
        Self {
            case,
            output: Output::default(),
            units: None,
            jobs: None,
            checkpoint_every: None,
            csv: false,
        }
    }
}

/// Outcome of a run.
#[derive(Debug)]
#[must_use = "the run may have stopped before its end"]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: Summary,
    /// Folder of the results.
    pub folder: PathBuf,
    /// Whether the folder contains a checkpoint from which the run can be resumed.
    pub is_resumable: bool,
    /// Reason why it stopped before its end; `None` if it is complete.
    pub stopped: Option<Stop>,
}

impl Outcome {
    /// Returns the outcome of a run that is complete.
    ///
    /// # Errors
    /// The reason why it is not.
    pub fn finished(mut self) -> Result<Self, Error> {
        match self.stopped.take() {
            None => Ok(self),
            Some(stop) => Err(stop.into()),
        }
    }
}

/// Solves a case, and writes its results, its picture and its page.
///
/// # Errors
/// A folder that cannot take the results, or a run that cannot be resumed. A later stop is reported
/// by the outcome, because the results until then are kept.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let case = request.case;
    let units = request.units.unwrap_or(case.units);
    let (claimed, mut record, under_way) = begin(request, units, observer)?;
    let folder = &claimed.folder;
    let every = request.checkpoint_every;
    let way = Way {
        keep: Keep::All,
        csv: request.csv,
        checkpoint_every: every.unwrap_or_else(|| checkpoint_every(case)),
        watch: Watch { observer, case: 0 },
        cancellation,
        executor: cores::for_rock(case, request.jobs, cancellation),
    };
    let solved = solve(case, &way, &mut record, Some(folder), under_way);
    // The page is made from the files, so only their summary is retained for the outcome.
    let summary = record.into_summary();
    let reported = page::write(folder, units);
    Ok(Outcome {
        summary,
        folder: folder.path().to_owned(),
        is_resumable: folder.has_checkpoint(),
        stopped: solved.and(reported.map_err(Stop::from)).err(),
    })
}

/// Locks the folder of a run, and reads the operations already solved.
fn begin(
    request: &Request<'_>,
    units: UnitSet,
    observer: &dyn Observer,
) -> Result<(Claimed, Record, Option<UnderWay<'static>>), Error> {
    let case = request.case;
    let occupant = Occupant {
        kind: "run".into(),
        name: case.name.clone(),
        identity: digest(&case.identity()),
    };
    if request.output.existing == Existing::Resume {
        let default = default_output(&request.output.root, &case.name);
        let folder = existing(request.output.folder.as_ref().unwrap_or(&default))?;
        let claimed = claim::hold(&folder)?;
        let stored = read_checkpoint(&folder, case)?;
        let record = Record::resume(case, units, &folder, stored.solved).map_err(anew)?;
        observer.folder(folder.path());
        return Ok((claimed.occupy(&occupant)?, record, stored.under_way));
    }
    // Checked before solving, so that a long run does not fail at its end on a folder that it may
    // not write to.
    let claimed = Claim {
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        ..Claim::new(occupant, &request.output, observer)
    }
    .folder()?;
    let record = Record::begin(case, units, &claimed.folder)?;
    Ok((claimed, record, None))
}

/// Error that a run cannot continue, with the reason.
fn anew(reason: String) -> Error {
    let noun = "case";
    Error::NotResumable { noun, reason }
}

/// The folder of a run to resume.
fn existing(path: &Path) -> Result<ResultsFolder, Error> {
    if !path.is_dir() {
        let place = path.display();
        return Err(Error::BadInput(format!("there is no folder {place}")));
    }
    Ok(ResultsFolder::create(path)?)
}

/// The run in the checkpoint of the folder, or the reason why there is none.
fn read_checkpoint(folder: &ResultsFolder, case: &Case) -> Result<RunCheckpoint<'static>, Error> {
    let place = folder.path().display();
    match RunCheckpoint::read(folder, case) {
        Ok(Some(stored)) => return Ok(stored),
        Ok(None) => {}
        Err(reason) => return Err(anew(reason)),
    }
    let Ok(summary) = Summary::read(&folder.path().join("summary.json")) else {
        return Err(anew(format!("there is no checkpoint in {place}")));
    };
    if let Err(reason) = is_of(&summary, case) {
        return Err(anew(format!(
            "there is no checkpoint in {place}, and the results there cannot be continued: \
             {reason}"
        )));
    }
    let failed = summary.operations.iter().find_map(|operation| match &operation.status {
        Status::Failed(reason) => Some(reason),
        _ => None,
    });
    if let Some(reason) = failed {
        return Err(Error::BadInput(format!(
            "the run in {place} failed and would fail again: {reason}"
        )));
    }
    let complete = summary.operations.iter();
    let complete = complete.filter(|complete| complete.status == Status::Complete).count();
    let all = case.operations.len() * case.models.len();
    Err(if complete == all {
        Error::BadInput(format!("the run in {place} is finished: nothing is left to do"))
    } else {
        anew(format!(
            "there is no checkpoint in {place}: the run ended before its first one, with \
             {complete} of {all} answers"
        ))
    })
}
