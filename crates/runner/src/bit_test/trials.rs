//! The trials of a bit test: all cores, one progress bar.

use std::{sync::Mutex, time::Instant};

use indicatif::ProgressBar;
use wholestring::rock::{Alone, DrillingResponse, Stepper, Trial, TrialOutcome};
use wholestring_case::{BitTest, Case};
use wholestring_results::{
    BIT_TEST_VERSION, BitTestPoint, BitTestSummary, ResultsError, ResultsFolder, Status,
};

use super::{
    laid::{self, Laid},
    points::Point,
    tables,
};
use crate::{
    args::{BatchArgs, Shard},
    checkpoint::{Keeper, other_processor},
    conclusion::Conclusion,
    failure::Failure,
    interrupt::Interrupt,
    parallel::{in_parallel, lock},
    progress::{self, Watch, milliseconds},
    solve::{Stop, checkpoint_every},
};

/// How a point ended.
type Ending = Result<TrialOutcome, Stop>;

/// Points that are drilled together.
pub(super) struct Trials<'a> {
    args: &'a BatchArgs,
    case: &'a Case,
    test: &'a BitTest,
    points: Vec<Point>,
    /// The points of this shard.
    mine: Vec<usize>,
    folder: ResultsFolder,
    stepper: Stepper,
    interrupt: Interrupt,
    bar: ProgressBar,
    /// How each point ended, none where it has not.
    endings: Mutex<Vec<Option<Ending>>>,
    /// Held by who writes the tables.
    writing: Mutex<()>,
    start: Instant,
}

impl<'a> Trials<'a> {
    /// Trials of these points, with results in the folder; the tables of an earlier test go.
    pub(super) fn new(
        args: &'a BatchArgs,
        case: &'a Case,
        test: &'a BitTest,
        points: Vec<Point>,
        folder: ResultsFolder,
    ) -> Result<Self, Failure> {
        let shard = args.shard.unwrap_or(Shard::ALL);
        let mine: Vec<usize> = (0..points.len())
            .filter(|point| shard.has(*point))
            .collect();
        let lengths = mine
            .iter()
            .map(|point| milliseconds(points[*point].spec.duration_s()));
        let bar = progress::bar(lengths.sum(), args.quiet);
        bar.set_prefix("bit test");
        let trials = Self {
            args,
            case,
            test,
            endings: Mutex::new(points.iter().map(|_| None).collect()),
            points,
            mine,
            folder,
            stepper: Stepper::default(),
            interrupt: Interrupt::listen(),
            bar,
            writing: Mutex::default(),
            start: Instant::now(),
        };
        if args.resume {
            trials.find_finished()?;
        }
        trials.write()?;
        Ok(trials)
    }

    /// Takes up the points that an earlier test finished, those of other shards too: the tables show all there is.
    fn find_finished(&self) -> Result<(), Failure> {
        let mut endings = lock(&self.endings);
        for (index, point) in self.points.iter().enumerate() {
            let place = self.folder.path().join(&point.name);
            endings[index] = laid::finished(&place, point).map(Ok);
            if endings[index].is_some() && self.mine.contains(&index) {
                // Killed as soon as the point was finished, the earlier test left this.
                ResultsFolder::create(place)?.remove_checkpoint()?;
            }
        }
        Ok(())
    }

    /// Drills the points of this shard.
    pub(super) fn solve_all(&self) -> Result<(), Failure> {
        // The slowest turn longest: what is left at the end is short.
        let mut order = self.mine.clone();
        let duration_s = |point: &usize| self.points[*point].spec.duration_s();
        order.sort_by(|a, b| duration_s(b).total_cmp(&duration_s(a)));
        in_parallel(self.args.jobs(), &order, |point| self.solve(point));
        self.bar.finish_and_clear();
        Ok(self.write()?)
    }

    /// Drills one point, unless it is finished or the user asked to stop.
    fn solve(&self, index: usize) {
        let point = &self.points[index];
        if lock(&self.endings)[index].is_some() {
            self.bar.inc(milliseconds(point.spec.duration_s()));
            return;
        }
        if self.interrupt.asked() {
            return;
        }
        let ending = self.ending(point);
        lock(&self.endings)[index] = Some(ending);
        // What cannot be written now is told at the end.
        let _ = self.write();
    }

    fn ending(&self, point: &Point) -> Ending {
        let folder = ResultsFolder::create(self.folder.path().join(&point.name))?;
        let begun = self
            .args
            .resume
            .then(|| self.begun(point, &folder))
            .flatten();
        let unsolved = |error: &dyn std::error::Error| Stop::Unsolved(error.to_string());
        let mut trial = match begun {
            Some(trial) => trial,
            None => {
                laid::begin(&folder)?;
                Trial::new(&point.spec, &self.test.drilling).map_err(|error| unsolved(&error))?
            }
        };
        let every = self.args.checkpoint;
        let every = every.unwrap_or_else(|| checkpoint_every(self.case));
        let mut keeper = Keeper::new(&folder, every);
        let watch = Watch::Sweep(self.bar.clone());
        let progress = watch.operation(&point.name, trial.time_s(), point.spec.duration_s());
        while !trial.is_finished() {
            progress.reach(trial.time_s());
            self.bar.set_message(self.message());
            let interrupted = self.interrupt.asked();
            if interrupted || keeper.is_due() {
                let laid = Laid::new(point, &self.stepper, &trial);
                // A point does not end because one checkpoint cannot be written: the next may.
                if let Err(error) = keeper.write(&laid) {
                    watch.tell(&format!("warning: no checkpoint: {error}\n"));
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
        progress.reach(trial.time_s());
        let outcome = trial.outcome().expect("a finished trial has an outcome");
        let bottom = tables::bottom(&trial.drilling().bottom_hole());
        folder.write_table(tables::BOTTOM, &bottom, self.args.csv)?;
        // With this the point is finished.
        laid::finish(&folder, point, outcome)?;
        keeper.finish()?;
        Ok(outcome)
    }

    /// What an earlier test began of the point; nothing where it left none to go on with, or none that one can.
    fn begun(&self, point: &Point, folder: &ResultsFolder) -> Option<Trial> {
        let watch = Watch::Sweep(self.bar.clone());
        match Laid::read(folder, point, &self.test.drilling) {
            Ok(laid) => laid.map(|laid| {
                let now = self.stepper.instructions;
                if let Some(warning) = other_processor(&laid.instructions, now) {
                    watch.tell(&warning);
                }
                laid.trial.into_owned()
            }),
            Err(reason) => {
                watch.tell(&format!(
                    "warning: {}: {reason}; it begins anew\n",
                    point.name
                ));
                None
            }
        }
    }

    /// Points that are finished.
    fn message(&self) -> String {
        let endings = lock(&self.endings);
        let done = self.mine.iter().filter(|point| endings[**point].is_some());
        let (done, all) = (done.count(), self.mine.len());
        format!("{done} of {all} points")
    }

    /// How far the test has come.
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
            schema_version: BIT_TEST_VERSION,
            case: self.case.name.clone(),
            settings: self.case.settings.clone(),
            rock_strength_Pa,
            bit_radius_m,
            response: DrillingResponse::of(&outcomes, &drilling.bit, rock_strength_Pa),
            points,
        }
    }

    /// Writes the summary and the tables of what there is.
    fn write(&self) -> Result<(), ResultsError> {
        let _alone = lock(&self.writing);
        let summary = self.summary();
        let points = &summary.points;
        self.folder
            .write_table(tables::POINTS, &tables::points(points), self.args.csv)?;
        tables::write_law(&self.folder, points)?;
        summary.write(&self.folder.path().join("summary.json"))
    }

    /// The folder with the results.
    pub(super) fn folder(&self) -> &ResultsFolder {
        &self.folder
    }

    /// Says how it went.
    pub(super) fn conclude(self) -> Result<(), Failure> {
        let endings = std::mem::take(&mut *lock(&self.endings));
        let of_mine = |point: &usize| (&self.points[*point], endings[*point].as_ref());
        let mine: Vec<_> = self.mine.iter().map(of_mine).collect();
        let failed = |(point, ending): &(&Point, Option<&Ending>)| {
            let reason = ending.as_ref()?.as_ref().err()?.reason()?;
            Some(format!("  {}: {reason}", point.name))
        };
        Conclusion {
            noun: "bit test",
            items: "points",
            all: mine.len(),
            finished: mine
                .iter()
                .filter(|(_, ending)| matches!(ending, Some(Ok(_))))
                .count(),
            failed: mine.iter().filter_map(failed).collect(),
            interrupted: self.interrupt.asked(),
            place: self.folder.path(),
            took: self.start.elapsed(),
        }
        .tell(self.args.quiet)
    }
}
