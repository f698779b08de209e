//! A sweep whose cases a front end distributes to other processes or machines.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
};

use wholestring_case::Override;
use wholestring_results::{ENGINE_VERSION, ResultsError, ResultsFolder, Summary};

use super::{
    batch::Batch,
    cases::Cases,
    checked_points::CheckedPoints,
    ending::{Ended, Ending},
    one_case::is_complete,
    pace::Pace,
    points::{points, points_together},
    remote_case::RemoteOptions,
    request::Request,
    set::Set,
};
use crate::{
    batch::{BatchOptions, BatchOutcome},
    cancellation::CancellationToken,
    claim::{Claimed, remove_results},
    clock::Instant,
    error::Error,
    keep::Keep,
    observer::Observer,
    output::Existing,
    page,
    parallel::{in_parallel, lock},
    share::Share,
};

/// Checks every case, solves them, and writes `sweep.csv` and a page next to the folders of the
/// cases.
///
/// # Errors
/// Cases that are invalid, or a folder that cannot take the results. The state of the cases is in
/// the outcome.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<BatchOutcome, Error> {
    PreparedSweep::begin(request, observer, cancellation)?.solve(observer, cancellation)
}

/// A sweep that is checked and has locked its folder, with cases ready to be solved.
///
/// Either [`Self::solve`] solves them here, on all cores, or a front end distributes them: each of
/// [`Self::left`] is [prepared](Self::make_ready), solved [separately](super::RemoteCase) anywhere,
/// and its outcome [recorded](Self::take); [`Self::end`] writes table and page.
pub struct PreparedSweep {
    cases: Cases,
    options: BatchOptions,
    claimed: Claimed,
    share: Share,
    endings: Vec<Option<Ending>>,
    pace: Pace,
    start: Instant,
}

impl PreparedSweep {
    /// Reads and checks every case, and claims the folder.
    ///
    /// # Errors
    /// Cases that are invalid, or a folder that cannot take the results.
    pub fn begin(
        request: &Request<'_>,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<Self, Error> {
        let options = &request.batch;
        let all = if request.together { points_together } else { points };
        if let Some(empty) = request.variations.iter().find(|variation| variation.values.is_empty())
        {
            return Err(Error::BadInput(format!("`{}` is given no values", empty.key)));
        }
        let points = all(request.template, request.overrides, request.variations)?;
        let valid = CheckedPoints::check(points, options, observer, cancellation)?;
        let name = format!("{} sweep", valid.first_name());
        let within_itself = |path: &Path, _| path.to_owned();
        let claimed = valid.claim("sweep", &name, options, observer, &within_itself)?;
        let share = Share::begin(&claimed, options.shard)?;
        let keys = request.variations.iter().map(|variation| variation.key.clone());
        let set = Set {
            prefix: String::new(),
            folder: claimed.folder.clone(),
            keys: keys.collect(),
            keep: request.keep,
            needs: Keep::Summary,
        };
        let cases = Cases::new(vec![set], valid);
        Ok(Self {
            endings: cases.points.iter().map(|_| None).collect(),
            cases,
            options: options.clone(),
            claimed,
            share,
            pace: Pace::default(),
            start: Instant::now(),
        })
    }

    /// Solves the cases here, on all cores, and writes table and page.
    ///
    /// # Errors
    /// Results that cannot be written.
    pub fn solve(
        self,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<BatchOutcome, Error> {
        let mut batch = Batch::of(&self.options, self.share, self.cases, observer, cancellation);
        batch.solve_all()?;
        Ok(batch.outcome(self.claimed.folder.path()))
    }

    /// Folder of the results.
    pub fn folder(&self) -> &Path {
        self.claimed.folder.path()
    }

    /// Number of cases.
    pub fn count(&self) -> usize {
        self.endings.len()
    }

    /// Name of a case and of its folder.
    ///
    /// # Panics
    /// If there is no case of this index, as in the other methods.
    pub fn name(&self, case: usize) -> &str {
        &self.cases.points[case].name
    }

    /// Changes of a case.
    pub fn changes(&self, case: usize) -> &[Override] {
        &self.cases.points[case].changes
    }

    /// Options for cases that are solved separately.
    pub fn remote_options(&self) -> RemoteOptions {
        let keep = self.cases.sets[0].keep;
        let BatchOptions { csv, checkpoint_every, .. } = self.options;
        RemoteOptions { keep, csv, checkpoint_every }
    }

    /// Indices of the cases to solve, the longest first. If the sweep is resumed, finished cases
    /// are read and excluded.
    pub fn left(&mut self) -> Vec<usize> {
        let mut order = self.cases.longest_first(self.options.shard);
        if self.options.output.existing == Existing::Resume {
            let found = Mutex::new(Vec::new());
            in_parallel(self.options.jobs(), &order, |case| {
                if let Some(ending) = self.finished(case) {
                    lock(&found).push((case, ending));
                }
            });
            let found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
            for (case, ending) in found {
                self.endings[case] = Some(ending);
            }
        }
        order.retain(|case| self.endings[*case].is_none());
        order
    }

    /// Outcome of a case that an earlier sweep finished completely. A finished case that is not
    /// found here may still be found when it is solved.
    fn finished(&self, case: usize) -> Option<Ending> {
        let (folder, checked) = (self.cases.folder(case), &self.cases.checked[case]);
        let summary = Summary::read(&folder.join("summary.json")).ok()?;
        let keep = self.keep(case);
        let whole = is_complete(&summary, checked.answers)
            && summary.identity.as_ref() == Some(&checked.identity)
            && summary.engine_version.as_deref() == Some(ENGINE_VERSION)
            && keep.has_tables(&folder)
            && (keep < Keep::All || folder.join(page::FILE).is_file())
            && !folder.join("checkpoint.bin").is_file();
        let solved = summary.operations;
        whole.then_some(Ending { solved, why: None, reused_s: checked.simulated_s })
    }

    fn keep(&self, case: usize) -> Keep {
        let by_csv = if self.options.csv { Keep::Tables } else { Keep::Summary };
        let by_itself = self.cases.checked[case].keep.max(by_csv);
        let set = &self.cases.sets[self.cases.points[case].set];
        set.keep.unwrap_or(by_itself).max(set.needs)
    }

    /// Prepares the folder of a case. If the sweep is not resumed, files of an earlier one are
    /// removed, so that the case can be distributed again to continue it.
    ///
    /// # Errors
    /// A folder that cannot be cleared.
    pub fn make_ready(&self, case: usize) -> Result<PathBuf, Error> {
        let folder = self.cases.folder(case);
        if self.options.output.existing != Existing::Resume && folder.is_dir() {
            remove_results(&folder)?;
        }
        Ok(folder)
    }

    /// Files, by name, with which another machine continues an unfinished case; empty if it was not
    /// begun, or if frames or parts of a long time history are kept, which are too large to send.
    pub fn begun(&self, case: usize) -> Vec<(String, Vec<u8>)> {
        const FILE: &str = "checkpoint.bin";
        let folder = self.cases.folder(case);
        let parts = ["frames.parts", "time.parts"];
        if parts.iter().any(|parts| folder.join(parts).is_dir())
            || self.options.output.existing != Existing::Resume
        {
            return Vec::new();
        }
        let file = fs::read(folder.join(FILE));
        file.map_or(Vec::new(), |bytes| vec![(FILE.to_owned(), bytes)])
    }

    /// Writes the files of a case that was solved elsewhere into its folder, replacing all existing
    /// ones; its summary last, because it marks the others as complete.
    ///
    /// # Errors
    /// Files that cannot be written.
    pub fn put(&self, case: usize, files: &[(String, Vec<u8>)]) -> Result<(), Error> {
        let folder = self.cases.folder(case);
        if folder.is_dir() {
            remove_results(&folder)?;
        }
        let folder = ResultsFolder::create(folder)?;
        let (last, first): (Vec<_>, Vec<_>) =
            files.iter().partition(|(name, _)| name == "summary.json");
        for (name, bytes) in first.into_iter().chain(last) {
            // The files of a case are in one folder without subfolders.
            if Path::new(name).file_name() != Some(name.as_ref()) {
                return Err(Error::BadInput(format!("`{name}` is no file of a case")));
            }
            folder.write_file(name, bytes)?;
        }
        Ok(())
    }

    /// Records the outcome of a case.
    pub fn take(&mut self, case: usize, ended: Ended) {
        self.endings[case] = Some(ended.into());
        if self.share.is_part() {
            return;
        }
        let (cases, endings) = (&self.cases, &self.endings);
        self.pace.when_due(|| {
            // A failure to write is reported at the end.
            let _ = cases.write_table(0, endings);
        });
    }

    /// Writes table and page of the cases that have ended, and returns the outcome.
    ///
    /// # Errors
    /// Results that cannot be written.
    pub fn end(&mut self, cancellation: &CancellationToken) -> Result<BatchOutcome, ResultsError> {
        let _gathering = self.cases.gather(&mut self.endings, &self.share, &self.options)?;
        self.cases.write(&self.endings)?;
        let shard = self.options.shard;
        let mine = (0..self.count()).filter(|case| shard.has(*case)).count();
        let outcome = BatchOutcome::begin(self.folder(), mine, self.start, cancellation);
        Ok(self.cases.conclude(&self.endings, &self.share, outcome))
    }
}
