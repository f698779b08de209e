//! A run that is requested, and how it ended.

use std::{
    num::NonZeroUsize,
    path::{Path, PathBuf},
    time::Duration,
};

use wholestring_case::Case;
use wholestring_results::{Occupant, ResultsFolder, Status, Summary, digest};
use wholestring_units::UnitSet;

use super::{
    solve::solve,
    stop::Stop,
    way::{Way, checkpoint_every},
};
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

/// A case that is to be solved.
#[derive(Debug, Clone)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// Where the results go. With [`Existing::Resume`] the run in the folder continues from its
    /// checkpoint.
    pub output: Output,
    /// Units of the checks, the picture and the page; the case's by default.
    pub units: Option<UnitSet>,
    /// Threads that work on solid rock under the bit, to the same answer; one per core where
    /// nothing is said.
    pub jobs: Option<NonZeroUsize>,
    /// Wall-clock time between checkpoints; the case's by default.
    pub checkpoint_every: Option<Duration>,
    /// Whether to write the tables as CSV too.
    pub csv: bool,
}

impl<'a> Request<'a> {
    /// The case with nothing said beside it.
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

/// How a run ended.
#[derive(Debug)]
#[must_use = "the run may have stopped before its end"]
pub struct Outcome {
    /// What it computed, as `summary.json` has it.
    pub summary: Summary,
    /// Where the results are.
    pub folder: PathBuf,
    /// Whether a checkpoint lies there from which it can be resumed.
    pub is_resumable: bool,
    /// Why it stopped before its end; nothing where it has come to it.
    pub stopped: Option<Stop>,
}

impl Outcome {
    /// The outcome of a run that has come to its end.
    ///
    /// # Errors
    /// Why it has not.
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
/// A folder that the results cannot go to, or a run that cannot be resumed. What stops the run
/// later is identified by its outcome, for what was computed until then is kept.
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
    // The page is made from the files: of what they hold, only the summary is compared with it.
    let summary = record.into_summary();
    let reported = page::write(folder, units);
    Ok(Outcome {
        summary,
        folder: folder.path().to_owned(),
        is_resumable: folder.has_checkpoint(),
        stopped: solved.and(reported.map_err(Stop::from)).err(),
    })
}

/// The folder of a run, held, with what was solved of it already.
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
    // Before anything is solved, so that a long run does not end on a folder it may not write to.
    let claimed = Claim {
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        ..Claim::new(occupant, &request.output, observer)
    }
    .folder()?;
    let record = Record::begin(case, units, &claimed.folder)?;
    Ok((claimed, record, None))
}

/// Why a run cannot continue.
fn anew(reason: String) -> Error {
    let noun = "case";
    Error::NotResumable { noun, reason }
}

/// The folder of a run that is to be resumed.
fn existing(path: &Path) -> Result<ResultsFolder, Error> {
    if !path.is_dir() {
        let place = path.display();
        return Err(Error::BadInput(format!("there is no folder {place}")));
    }
    Ok(ResultsFolder::create(path)?)
}

/// The run that was written to a checkpoint in the folder, or why there is none.
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
            "there is no checkpoint in {place}, and what lies there cannot be continued: {reason}"
        )));
    }
    let failed = summary.operations.iter().find_map(|of| match &of.status {
        Status::Failed(reason) => Some(reason),
        _ => None,
    });
    if let Some(reason) = failed {
        return Err(Error::BadInput(format!(
            "the run in {place} failed and would fail again: {reason}"
        )));
    }
    let complete = summary.operations.iter();
    let complete = complete.filter(|of| of.status == Status::Complete).count();
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
