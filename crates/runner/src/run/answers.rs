//! What a case comes to, in memory.

use std::{num::NonZeroUsize, path::PathBuf, time::Duration};

use wholestring_case::Case;
use wholestring_results::{Occupant, Summary, Table, digest};
use wholestring_units::UnitSet;

use super::{solve::solve, stop::Stop, way::Way};
use crate::{
    cancellation::CancellationToken,
    claim::Claim,
    cores,
    error::Error,
    keep::Keep,
    observer::{Observer, Watch},
    output::Output,
    page,
    record::Record,
};

/// What a case comes to, in memory: the summary and the tables that [`run`](super::run) writes, and
/// nothing on the disk until [`Answers::save`].
pub struct Answers {
    record: Record,
    identity: String,
    name: String,
    units: UnitSet,
}

/// How solving in memory ended.
#[must_use = "it may have stopped before its end"]
pub struct Solved {
    /// What was computed.
    pub answers: Answers,
    /// Why it stopped before its end; nothing where it has come to it.
    pub stopped: Option<Stop>,
}

/// Solves a case, operation after operation, with all of its models, and writes nothing. `jobs` are
/// the threads that work on solid rock under the bit; one per core where nothing is said.
///
/// # Errors
/// A case that keeps frames of the whole string: these go to the disk as they are taken, which
/// [`run`](super::run) does. What stops the work later is told by the outcome, for what was computed
/// until then is kept.
pub fn answer(
    case: &Case,
    jobs: Option<NonZeroUsize>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Solved, Error> {
    if case.records.frame_interval_s.is_some() {
        let message = "frames of the whole string are written to a folder as they are taken: a case \
                       with [records] frames is run into one";
        return Err(Error::BadInput(message.to_owned()));
    }
    let way = Way {
        keep: Keep::All,
        csv: false,
        checkpoint_every: Duration::MAX,
        watch: Watch { observer, case: 0 },
        cancellation,
        executor: cores::for_rock(case, jobs, cancellation),
    };
    let mut record = Record::in_memory(case, case.units);
    let stopped = solve(case, &way, &mut record, None, None).err();
    Ok(Solved { answers: Answers::of(case, record), stopped })
}

impl Answers {
    pub(super) fn of(case: &Case, record: Record) -> Self {
        let identity = digest(&case.identity());
        Self { record, identity, name: case.name.clone(), units: case.units }
    }

    /// The summary, as `summary.json` has it.
    pub fn summary(&self) -> &Summary {
        &self.record.summary
    }

    /// The tables that have rows, each with the name of its file without the ending.
    pub fn tables(&self) -> Vec<(&'static str, &Table)> {
        self.record.tables().into_iter().filter(|(_, table)| table.rows() > 0).collect()
    }

    /// Writes what a run of the case leaves, its page and its picture too, and gives the folder: the
    /// one that `output` names, or `out/<name>`. With `csv` the tables are written as CSV too.
    ///
    /// # Errors
    /// A folder that the results cannot go to.
    pub fn save(
        &self,
        output: &Output,
        csv: bool,
        observer: &dyn Observer,
    ) -> Result<PathBuf, Error> {
        let occupant = Occupant {
            kind: "run".into(),
            name: self.name.clone(),
            identity: self.identity.clone(),
        };
        let claimed = Claim {
            is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
            ..Claim::new(occupant, output, observer)
        }
        .folder()?;
        let folder = &claimed.folder;
        folder.remove_checkpoint()?;
        // What is written leaves the memory of the record that writes it.
        self.record.copy_in_memory().write(folder, Keep::All, csv)?;
        page::write(folder, self.units)?;
        Ok(folder.path().to_owned())
    }
}
