//! Sets of cases that are solved together, on all cores.

use std::{
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
    time::{Duration, Instant},
};

use wholestring_case::Case;
use wholestring_contain::{Panicked, contain};
use wholestring_results::{OperationSummary, ResultsError, ResultsFolder, Status, Summary};

use super::{
    checked::Checked,
    checked_points::CheckedPoints,
    page as sweep_page,
    points::Point,
    set::Set,
    table::{FILE, SweepTable},
};
use crate::{
    batch::{BatchOptions, BatchOutcome, CaseWithErrors, FailedCase},
    cancellation::CancellationToken,
    checkpoint::{RunCheckpoint, UnderWay, is_of},
    cores, findings,
    keep::Keep,
    observer::{BatchSize, CaseEnded, Observer, Watch},
    output::Existing,
    page,
    parallel::{in_parallel, lock},
    record::Record,
    run::{Stop, Way, checkpoint_every, solve},
};

/// Time between two writings of a `sweep.csv` while its cases are solved.
const WRITE_INTERVAL: Duration = Duration::from_secs(5);

/// How a case ended.
pub(crate) struct Ending {
    pub(crate) solved: Vec<OperationSummary>,
    /// Nothing where it is finished.
    why: Option<Stop>,
    /// Simulated time that an earlier batch had solved, s.
    reused_s: f64,
}

/// How far a batch has come.
struct Reached {
    /// How each case of all shards ended, none where it has not.
    endings: Vec<Option<Ending>>,
    count: usize,
    /// When a `sweep.csv` was written last.
    written: Instant,
}

/// Sets of cases that are solved together.
pub(crate) struct Batch<'a> {
    options: &'a BatchOptions,
    sets: Vec<Set>,
    points: Vec<Point<'a>>,
    checked: Vec<Checked>,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
    /// The cases of this shard.
    mine: Vec<usize>,
    progress: Mutex<Reached>,
    start: Instant,
}

impl<'a> Batch<'a> {
    /// A batch of sound cases that belong to these sets.
    pub(crate) fn new(
        options: &'a BatchOptions,
        sets: Vec<Set>,
        valid: CheckedPoints<'a>,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Self {
        let CheckedPoints { points, checked } = valid;
        let shard = options.shard;
        let mine: Vec<usize> = (0..points.len()).filter(|case| shard.has(*case)).collect();
        Self {
            options,
            sets,
            observer,
            cancellation,
            mine,
            progress: Mutex::new(Reached {
                endings: points.iter().map(|_| None).collect(),
                count: 0,
                written: Instant::now(),
            }),
            points,
            checked,
            start: Instant::now(),
        }
    }

    /// Solves the cases of this shard, and writes table and page of each set.
    pub(crate) fn solve_all(&mut self) -> Result<(), ResultsError> {
        let simulated_s = self.mine.iter().map(|case| self.checked[*case].simulated_s);
        self.observer.batch_started(&BatchSize {
            cases: self.mine.len(),
            finished: 0,
            simulated_s: simulated_s.sum(),
        });
        // The longest first: what is left at the end is short, and no thread waits long for the
        // others.
        let mut order = self.mine.clone();
        order.sort_by(|a, b| self.checked[*b].cost.total_cmp(&self.checked[*a].cost));
        in_parallel(self.options.jobs(), &order, |case| self.solve(case));
        self.observer.batch_ended();
        let reached = lock(&self.progress);
        (0..self.sets.len()).try_for_each(|set| {
            self.write(set, &reached.endings)?;
            sweep_page::write(&self.sets[set].folder, None)
        })
    }

    /// Each case with its set and how it ended; nothing where it has not, or is another shard's.
    pub(crate) fn cases(&mut self) -> impl Iterator<Item = (&Set, &Point<'a>, Option<&Ending>)> {
        let reached = self.progress.get_mut();
        let reached = reached.unwrap_or_else(PoisonError::into_inner);
        let (sets, points) = (&self.sets, self.points.iter());
        points
            .zip(&reached.endings)
            .map(move |(point, ending)| (&sets[point.set], point, ending.as_ref()))
    }

    /// Solves one case, unless it is cancelled.
    fn solve(&self, case: usize) {
        if self.cancellation.is_cancelled() {
            return;
        }
        // A mistake of the program in one case is no reason to lose the others.
        let ending = contain(|| self.ending(case))
            .unwrap_or_else(|Panicked(mistake)| {
                Err(Stop::Unsolved(format!(
                    "a mistake of the program, please report it: {mistake}"
                )))
            })
            .unwrap_or_else(|why| Ending { solved: Vec::new(), why: Some(why), reused_s: 0.0 });
        let reused_s = ending.reused_s;
        let mut reached = lock(&self.progress);
        reached.endings[case] = Some(ending);
        reached.count += 1;
        self.observer.case_ended(&CaseEnded {
            ended: reached.count,
            of: self.mine.len(),
            reused_s,
        });
        if reached.written.elapsed() >= WRITE_INTERVAL {
            // What cannot be written now is reported at the end.
            let _ = self.write(self.points[case].set, &reached.endings);
            reached.written = Instant::now();
        }
    }

    fn ending(&self, number: usize) -> Result<Ending, Stop> {
        let (point, checked) = (&self.points[number], &self.checked[number]);
        let case = match checked.take() {
            Some(case) => case,
            None => point
                .template
                .case(&point.changes)
                .map_err(|report| Stop::Unsolved(report.render(false)))?,
        };
        let folder = ResultsFolder::create(self.folder(point))?;
        let keep = self.sets[point.set].keep(&case, self.options.csv);
        let mut begun = None;
        if self.options.output.existing == Existing::Resume {
            match finished(folder.path(), &case, keep) {
                Ok(Some(solved)) => {
                    // Killed between its last result and its end, a run may leave one.
                    folder.remove_checkpoint()?;
                    if keep == Keep::All {
                        page::complete(&folder, case.units)?;
                    }
                    return Ok(Ending { solved, why: None, reused_s: checked.simulated_s });
                }
                Ok(None) => begun = self.begun(point, &case, &folder),
                Err(reason) => self.warn_of(point, &reason),
            }
        }
        let (mut record, under_way) = match begun {
            Some(begun) => begun,
            None => (Record::begin(&case, case.units, &folder)?, None),
        };
        let way = Way {
            keep,
            csv: self.options.csv,
            checkpoint_every: self
                .options
                .checkpoint_every
                .unwrap_or_else(|| checkpoint_every(&case)),
            watch: Watch { observer: self.observer, case: number },
            cancellation: self.cancellation,
            // Cases are what the cores share.
            executor: cores::alone(self.cancellation),
        };
        let why = solve(&case, &way, &mut record, Some(&folder), under_way).err();
        if keep == Keep::All {
            page::write(&folder, case.units)?;
        }
        Ok(Ending { solved: record.into_summary().operations, why, reused_s: 0.0 })
    }

    /// What an earlier sweep began of the case; nothing where it left none to continue with, or
    /// none that one can.
    fn begun(
        &self,
        point: &Point,
        case: &Case,
        folder: &ResultsFolder,
    ) -> Option<(Record, Option<UnderWay<'static>>)> {
        let begun = RunCheckpoint::<'static>::read(folder, case).and_then(|stored| {
            let Some(stored) = stored else {
                return Ok(None);
            };
            let record = Record::resume(case, case.units, folder, stored.solved)?;
            Ok(Some((record, stored.under_way)))
        });
        begun.unwrap_or_else(|reason| {
            self.warn_of(point, &reason);
            None
        })
    }

    /// Says why a case does not continue from what lies in its folder.
    fn warn_of(&self, point: &Point<'_>, reason: &str) {
        let label = self.label(point);
        let warning = format!("{label}: {reason}; it begins anew");
        self.observer.warning(&warning);
    }

    /// The folder of a case.
    fn folder(&self, point: &Point<'_>) -> PathBuf {
        self.sets[point.set].folder.path().join(&point.name)
    }

    /// What messages call a case.
    fn label(&self, point: &Point<'_>) -> String {
        format!("{}{}", self.sets[point.set].prefix, point.name)
    }

    /// Writes a set's `sweep.csv`: its cases in their order, as far as they have ended.
    fn write(&self, set: usize, endings: &[Option<Ending>]) -> Result<(), ResultsError> {
        let of_set = |case: &usize| self.points[*case].set == set;
        let cases = || (0..self.points.len()).filter(of_set);
        let dynamic = cases().any(|case| self.checked[case].simulated_s > 0.0);
        let lift = cases().any(|case| self.checked[case].lift);
        let mut table = SweepTable::new(self.sets[set].keys.clone(), dynamic, lift);
        for case in cases() {
            if let Some(Ending { solved, why, .. }) = &endings[case] {
                let failure = why.as_ref().and_then(Stop::reason);
                let point = &self.points[case];
                table.add(&point.values, &point.name, solved, failure.as_deref());
            }
        }
        let path = self.sets[set].folder.path().join(FILE);
        table.table().write_csv(&path)
    }

    /// How it went; its results are in `place`.
    pub(crate) fn outcome(self, place: &Path) -> BatchOutcome {
        let endings = std::mem::take(&mut lock(&self.progress).endings);
        let mut outcome =
            BatchOutcome::begin(place, self.mine.len(), self.start, self.cancellation);
        for (point, ending) in self.points.iter().zip(&endings) {
            let Some(Ending { solved, why, .. }) = ending else {
                continue;
            };
            match why.as_ref().map(Stop::reason) {
                None => outcome.finished += 1,
                Some(reason) => outcome
                    .failed
                    .extend(reason.map(|reason| FailedCase { name: self.label(point), reason })),
            }
            let wrong = solved.iter().filter(|of| findings::is_wrong(of));
            let operations: Vec<String> = wrong.map(findings::name).collect();
            if !operations.is_empty() {
                outcome.with_errors.push(CaseWithErrors { name: self.label(point), operations });
            }
        }
        outcome
    }
}

/// What a finished run of the case left in the folder; nothing if there is none, it is not
/// finished, or has not kept what is to be kept.
///
/// # Errors
/// Why what lies there is not the case's.
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
    let complete = summary.operations.len() == all
        && summary.operations.iter().all(|of| of.status == Status::Complete);
    Ok((complete && keep.has_tables(folder)).then_some(summary.operations))
}
