//! The trials of a bit test, on all cores.

use std::sync::{Mutex, PoisonError};

use wholestring::rock::{Alone, DrillingResponse, Stepper, Trial, TrialOutcome};
use wholestring_case::{BitTest, Case};
use wholestring_judge::{Check, TriedPoint, bit_test_checks};
use wholestring_results::{
    BIT_TEST_VERSION, BitTestPoint, BitTestSummary, ResultsError, ResultsFolder, Row as _, Status,
};

use super::{
    points::{self, Point, PointCheckpoint},
    tables,
};
use crate::{
    batch::{BatchOptions, BatchOutcome, FailedCase},
    cancellation::CancellationToken,
    checkpoint::Keeper,
    clock::Instant,
    observer::{BatchSize, CaseEnded, Observer, Watch},
    output::Existing,
    parallel::{in_parallel, lock},
    run::{Stop, checkpoint_every},
    share::{Gathering, Share},
};

/// Outcome of a point.
type Ending = Result<TrialOutcome, Stop>;

/// Points that are drilled together.
pub(super) struct Trials<'a> {
    options: &'a BatchOptions,
    share: Share,
    /// Held from the end of the points of this share, because tables and page contain all shares.
    gathering: Option<Gathering>,
    case: &'a Case,
    test: &'a BitTest,
    points: Vec<Point>,
    /// Indices of the points of this shard.
    mine: Vec<usize>,
    folder: ResultsFolder,
    stepper: Stepper,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
    /// Outcome of each point, `None` until it has ended.
    endings: Mutex<Vec<Option<Ending>>>,
    /// Held while the tables are written.
    writing: Mutex<()>,
    start: Instant,
}

impl<'a> Trials<'a> {
    /// Creates the trials of these points, with results in the folder; removes the tables of an
    /// earlier test.
    #[allow(clippy::too_many_arguments, reason = "each is a part of what is tried, once")]
    pub(super) fn new(
        options: &'a BatchOptions,
        share: Share,
        case: &'a Case,
        test: &'a BitTest,
        points: Vec<Point>,
        folder: ResultsFolder,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Result<Self, ResultsError> {
        let shard = options.shard;
        let mine: Vec<usize> = (0..points.len()).filter(|point| shard.has(*point)).collect();
        let trials = Self {
            options,
            share,
            gathering: None,
            case,
            test,
            endings: Mutex::new(points.iter().map(|_| None).collect()),
            points,
            mine,
            folder,
            stepper: Stepper::default(),
            observer,
            cancellation,
            writing: Mutex::default(),
            start: Instant::now(),
        };
        if options.output.existing == Existing::Resume {
            trials.find_finished()?;
        }
        if !trials.share.is_part() {
            trials.write()?;
        }
        Ok(trials)
    }

    /// Reads the points that an earlier test has finished, including those of other shards, so that
    /// the tables are complete.
    fn find_finished(&self) -> Result<(), ResultsError> {
        let mut endings = lock(&self.endings);
        for (index, point) in self.points.iter().enumerate() {
            let place = self.folder.path().join(&point.name);
            endings[index] = points::finished(&place, point).map(Ok);
            if endings[index].is_some() && self.mine.contains(&index) {
                // Left by a test that was killed just after the point was finished.
                ResultsFolder::create(place)?.remove_checkpoint()?;
            }
        }
        Ok(())
    }

    /// Reads the results of the other shares, and keeps them from writing tables and page until
    /// this is dropped.
    fn gather(&mut self) -> Result<(), ResultsError> {
        let endings = self.endings.get_mut().unwrap_or_else(PoisonError::into_inner);
        let failed = self.points.iter().zip(&*endings).filter_map(|(point, ending)| {
            let reason = ending.as_ref()?.as_ref().err()?.reason()?;
            Some((point.name.clone(), reason))
        });
        self.gathering = Some(self.share.gather(failed.collect())?);
        if self.share.is_part() {
            let mut failed = self.share.failed_of_others();
            for (point, ending) in self.points.iter().zip(endings) {
                if ending.is_none() {
                    let place = self.folder.path().join(&point.name);
                    let failed = failed.remove(&point.name).map(|why| Err(Stop::Unsolved(why)));
                    *ending = points::finished(&place, point).map(Ok).or(failed);
                }
            }
        }
        Ok(())
    }

    /// Drills the points of this shard.
    pub(super) fn solve_all(&mut self) -> Result<(), ResultsError> {
        let durations_s = self.mine.iter();
        let durations_s = durations_s.map(|point| self.points[*point].spec.duration_s());
        self.observer.batch_started(&BatchSize {
            cases: self.mine.len(),
            finished: self.ended(),
            simulated_s: durations_s.sum(),
        });
        // The point with the slowest rotation takes longest and comes first, so that the last jobs
        // are short.
        let mut order = self.mine.clone();
        let duration_s = |point: &usize| self.points[*point].spec.duration_s();
        order.sort_by(|a, b| duration_s(b).total_cmp(&duration_s(a)));
        in_parallel(self.options.jobs(), &order, |point| self.solve(point));
        self.observer.batch_ended();
        self.gather()?;
        self.write()
    }

    /// Drills one point, unless it is finished or the test is cancelled.
    fn solve(&self, index: usize) {
        let point = &self.points[index];
        if lock(&self.endings)[index].is_some() {
            self.report_end(point.spec.duration_s());
            return;
        }
        if self.cancellation.is_cancelled() {
            return;
        }
        let ending = self.ending(index);
        lock(&self.endings)[index] = Some(ending);
        self.report_end(0.0);
        if !self.share.is_part() {
            // A failure to write is reported at the end.
            let _ = self.write();
        }
    }

    fn ending(&self, index: usize) -> Ending {
        let point = &self.points[index];
        let folder = ResultsFolder::create(self.folder.path().join(&point.name))?;
        let begun = match self.options.output.existing {
            Existing::Resume => self.begun(point, &folder),
            Existing::Protect | Existing::Overwrite => None,
        };
        let unsolved = |error: &dyn std::error::Error| Stop::Unsolved(error.to_string());
        let mut trial = match begun {
            Some(trial) => trial,
            None => {
                points::begin(&folder)?;
                Trial::new(&point.spec, &self.test.drilling).map_err(|error| unsolved(&error))?
            }
        };
        let every = self.options.checkpoint_every;
        let every = every.unwrap_or_else(|| checkpoint_every(self.case));
        let mut keeper = Keeper::new(&folder, every);
        let watch = Watch { observer: self.observer, case: index };
        let duration_s = point.spec.duration_s();
        let progress = watch.simulation(&point.name, None, [trial.time_s(), duration_s]);
        while !trial.is_finished() {
            progress.reach(trial.time_s(), duration_s, false);
            let interrupted = self.cancellation.is_cancelled();
            if interrupted || keeper.is_due() {
                let stored = PointCheckpoint::new(point, &trial);
                // The point continues even if a checkpoint cannot be written, because the next one
                // may succeed.
                if let Err(error) = keeper.write(&stored) {
                    self.observer.warning(&format!("no checkpoint: {error}"));
                }
            }
            if interrupted {
                return Err(Stop::Interrupted);
            }
            if let Err(error) = trial.advance(1, &self.stepper, &Alone) {
                keeper.finish()?;
                return Err(unsolved(&error));
            }
        }
        progress.reach(trial.time_s(), duration_s, false);
        let outcome = trial.outcome().expect("a finished trial has an outcome");
        let bottom = tables::bottom(&trial.drilling().bottom_hole());
        folder.write_table(tables::BOTTOM, &bottom, self.options.csv)?;
        // Marks the point as finished.
        points::finish(&folder, point, outcome)?;
        keeper.finish()?;
        Ok(outcome)
    }

    /// Unfinished trial of the point from an earlier test; `None` if there is none that can be
    /// continued.
    fn begun(&self, point: &Point, folder: &ResultsFolder) -> Option<Trial> {
        match PointCheckpoint::read(folder, point, &self.test.drilling) {
            Ok(stored) => stored.map(|stored| stored.trial.into_owned()),
            Err(reason) => {
                let name = &point.name;
                let warning = format!("{name}: {reason}; it starts again");
                self.observer.warning(&warning);
                None
            }
        }
    }

    /// Number of points of this shard that have ended.
    fn ended(&self) -> usize {
        let endings = lock(&self.endings);
        let done = self.mine.iter().filter(|point| endings[**point].is_some());
        done.count()
    }

    /// Reports that a point has ended; `reused_s` of it were drilled earlier.
    fn report_end(&self, reused_s: f64) {
        self.observer.case_ended(&CaseEnded { ended: self.ended(), of: self.mine.len(), reused_s });
    }

    /// Summary of the test so far.
    pub(super) fn summary(&self) -> BitTestSummary {
        let endings = lock(&self.endings);
        let points = self.points.iter().zip(endings.iter());
        let points: Vec<BitTestPoint> = points
            .map(|(point, ending)| BitTestPoint {
                point: point.name.clone(),
                status: match ending {
                    Some(Ok(_)) => Status::Complete,
                    Some(Err(why)) => why.reason().map_or(Status::Interrupted, Status::Failed),
                    None => Status::Interrupted,
                },
                weight_on_bit_N: point.spec.weight_N,
                rotary_speed_rad_per_s: point.spec.rotary_rad_per_s,
                outcome: match ending {
                    Some(Ok(outcome)) => Some(*outcome),
                    _ => None,
                },
            })
            .collect();
        let outcomes: Vec<TrialOutcome> = points.iter().filter_map(|point| point.outcome).collect();
        let drilling = &self.test.drilling;
        let bit_radius_m = 0.5 * drilling.bit.diameter_m();
        let rock_strength_Pa = drilling.block.rock.ucs_Pa();
        BitTestSummary {
            checks: checks(&points),
            schema_version: BIT_TEST_VERSION,
            case: self.case.name.clone(),
            settings: self.case.settings.clone(),
            rock_strength_Pa,
            bit_radius_m,
            response: DrillingResponse::of(&outcomes, &drilling.bit, rock_strength_Pa),
            points,
        }
    }

    /// Writes summary and tables of the points so far.
    fn write(&self) -> Result<(), ResultsError> {
        let _alone = lock(&self.writing);
        let summary = self.summary();
        let points = &summary.points;
        self.folder.write_table(tables::POINTS, &BitTestPoint::table(points), self.options.csv)?;
        tables::write_law(&self.folder, points)?;
        summary.write(&self.folder.path().join("summary.json"))
    }

    /// Outcome of the test.
    pub(super) fn outcome(self) -> BatchOutcome {
        let endings = std::mem::take(&mut *lock(&self.endings));
        let (folder, all) = (self.folder.path(), self.mine.len());
        let mut outcome = BatchOutcome::begin(folder, all, self.start, self.cancellation);
        outcome.known = (endings.iter().flatten().count(), endings.len());
        for point in &self.mine {
            match &endings[*point] {
                Some(Ok(_)) => outcome.finished += 1,
                Some(Err(why)) => {
                    let failed = why.reason().map(|reason| FailedCase {
                        name: self.points[*point].name.clone(),
                        reason,
                    });
                    outcome.failed.extend(failed);
                }
                None => {}
            }
        }
        outcome
    }
}

// Checks of the points of a bit test.

/// Returns the checks of all points, the most severe first.
pub(super) fn checks(points: &[BitTestPoint]) -> Vec<Check> {
    let tried = points.iter().map(|point| {
        let failure = match &point.status {
            Status::Failed(reason) => Some(reason.as_str()),
            _ => None,
        };
        TriedPoint { name: &point.point, failure, outcome: point.outcome.as_ref() }
    });
    bit_test_checks(&tried.collect::<Vec<_>>())
}
