//! Results of a case in memory.

use std::{
    num::NonZeroUsize,
    path::{Path, PathBuf},
    time::Duration,
};

use wholestring_case::Case;
use wholestring_results::{Occupant, ResultsError, Summary, Table, digest};
use wholestring_units::UnitSet;

use super::{
    solve::solve,
    way::{Stop, Way},
};
use crate::{
    cancellation::CancellationToken,
    claim::Claim,
    cores,
    error::Error,
    keep::Keep,
    observer::{Observer, Watch},
    output::Output,
    page,
    record::{self, Record, RunTables},
};

/// Results of a case in memory: the summary and the tables that [`run`](super::run) writes. No
/// files are written before [`Answers::save`].
pub struct Answers {
    summary: Summary,
    tables: RunTables,
    identity: String,
    name: String,
    units: UnitSet,
}

/// Outcome of solving in memory.
#[must_use = "it may have stopped before its end"]
pub struct Solved {
    /// Computed results.
    pub answers: Answers,
    /// Reason why it stopped before its end; `None` if it is complete.
    pub stopped: Option<Stop>,
}

/// Solves a case, operation after operation, with all of its models, without writing files. `jobs`
/// are the threads that work on solid rock under the bit; one per core by default.
///
/// # Errors
/// A case that keeps frames of the whole string, because these are written to the disk as they are
/// computed; use [`run`](super::run) instead. A later stop is reported by the outcome, because the
/// results until then are kept.
pub fn answer(
    case: &Case,
    jobs: Option<NonZeroUsize>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Solved, Error> {
    if case.records.frame_interval_s.is_some() {
        let message = "frames of the whole string are written to a folder as they are computed: \
                       run a case with [records] frames into a folder";
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
        let (summary, tables) = record.into_parts();
        Self { summary, tables, identity, name: case.name.clone(), units: case.units }
    }

    /// Restores answers from their [`Answers::summary`] as JSON, their [`Answers::tables`], and
    /// whether the case requires spectra, as sent by another process.
    ///
    /// # Errors
    /// A summary of a newer version, or a table that is not one of a run.
    pub fn restore(
        summary: &str,
        tables: Vec<(String, Table)>,
        with_spectra: bool,
    ) -> Result<Self, ResultsError> {
        let place = Path::new("summary.json");
        let bad = |reason: String| ResultsError::Format { path: place.to_owned(), reason };
        let summary = Summary::parse(place, summary)?;
        let tables = RunTables::with(with_spectra, tables);
        let tables =
            tables.map_err(|name| bad(format!("its table `{name}` is not one of a run")))?;
        let identity = summary.identity.clone();
        let identity = identity.ok_or_else(|| bad("it does not name its case".to_owned()))?;
        let units = summary.settings.get("units").and_then(|setting| setting.as_str());
        let units = units.and_then(|unit| unit.parse().ok());
        let units = units.ok_or_else(|| bad("it does not name its units".to_owned()))?;
        Ok(Self { name: summary.case.clone(), summary, tables, identity, units })
    }

    /// The summary, as in `summary.json`.
    pub fn summary(&self) -> &Summary {
        &self.summary
    }

    /// Whether the case requires spectra: their file is then written even without rows.
    pub fn with_spectra(&self) -> bool {
        self.tables.with_spectra()
    }

    /// Tables with rows, each with the name of its file without extension.
    pub fn tables(&self) -> Vec<(&'static str, &Table)> {
        self.tables.named().into_iter().filter(|(_, table)| table.rows() > 0).collect()
    }

    /// Writes the files of a run of the case, including its page and picture, and returns the
    /// folder: the one in `output`, or `out/<name>`. With `csv` the tables are also written as CSV.
    ///
    /// # Errors
    /// A folder that cannot take the results.
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
        // Writing takes the rows out of the tables, so a copy is written.
        self.tables.clone().write(folder, Keep::All, csv)?;
        folder.remove("frames.parquet")?;
        record::write_summary(folder, Keep::All, &self.summary, self.units)?;
        page::write(folder, self.units)?;
        Ok(folder.path().to_owned())
    }
}
