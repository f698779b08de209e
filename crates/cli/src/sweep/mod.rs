//! `wholestring sweep`: solves a case for all combinations of some values.

mod checked;
mod parallel;
mod points;
pub(crate) mod report;
mod table;

use std::{
    num::NonZeroUsize,
    path::Path,
    sync::Mutex,
    thread,
    time::{Duration, Instant},
};

use indicatif::ProgressBar;
use wholestring_case::{Case, Report, Template, Variation};
use wholestring_results::{OperationSummary, ResultsFolder, Status, Summary};

use self::{
    checked::{Checked, check},
    parallel::{in_parallel, lock},
    points::{Point, points},
    table::{FILE, SweepTable},
};
use crate::{
    args::{Shard, SweepArgs},
    checkpoint::{Laid, UnderWay, difference},
    color,
    failure::Failure,
    folder_name::default_output,
    interrupt::Interrupt,
    progress::{self, Watch, milliseconds},
    record::Record,
    say,
    solve::{Stop, Way, checkpoint_every, solve},
};

/// Time between two writings of `sweep.csv` while the sweep goes on.
const WRITE_INTERVAL: Duration = Duration::from_secs(5);

pub(crate) fn sweep(args: &SweepArgs) -> Result<(), Failure> {
    let refused = |report: Report| Failure::BadInput(report.render(color()));
    let variations = Variation::read_all(&args.vary).map_err(refused)?;
    let template = Template::read(&args.case.case).map_err(refused)?;
    let jobs = args.jobs.or_else(|| thread::available_parallelism().ok());
    let jobs = jobs.map_or(1, NonZeroUsize::get);
    let points = points(&args.case.overrides, &variations)?;
    let checked = check(&template, &points, jobs, args.quiet)?;
    let output = args.output.clone().unwrap_or_else(|| {
        let name = format!("{} sweep", checked[0].name);
        default_output(&name)
    });
    let folder = ResultsFolder::create(output)?;
    let interrupt = Interrupt::listen();
    let shard = args.shard.unwrap_or(Shard::ALL);
    let mine: Vec<usize> = (0..points.len()).filter(|case| shard.has(*case)).collect();
    let sweep = Sweep {
        args,
        template: &template,
        points: &points,
        folder: &folder,
        interrupt: &interrupt,
        bar: sweep_bar(mine.iter().map(|case| &checked[*case]), args.quiet),
        cases: mine.len(),
        keys: variations.iter().map(|of| of.key.clone()).collect(),
        dynamic: checked.iter().any(|case| case.simulated_s > 0.0),
        progress: Mutex::new(Reached {
            endings: points.iter().map(|_| None).collect(),
            count: 0,
            written: Instant::now(),
        }),
        start: Instant::now(),
    };
    // The longest first: what is left at the end is short, and no thread waits long for the others.
    let mut order = mine;
    order.sort_by(|a, b| checked[*b].cost.total_cmp(&checked[*a].cost));
    in_parallel(jobs, &order, |case| sweep.solve(case));
    sweep.bar.finish_and_clear();
    sweep.conclude()
}

/// Besides its simulated time, a case counts as one millisecond on the bar, so that soft strings move
/// it too.
fn sweep_bar<'a>(cases: impl Iterator<Item = &'a Checked>, quiet: bool) -> ProgressBar {
    let length = cases.map(|case| 1 + milliseconds(case.simulated_s)).sum();
    let bar = progress::bar(length, quiet);
    bar.set_prefix("sweep");
    bar
}

/// How a case ended.
struct Ending {
    solved: Vec<OperationSummary>,
    /// Nothing where it is finished.
    why: Option<Stop>,
}

/// How far a sweep has come.
struct Reached {
    /// How each case of all shards ended, none where it has not.
    endings: Vec<Option<Ending>>,
    count: usize,
    /// When `sweep.csv` was written last.
    written: Instant,
}

struct Sweep<'a> {
    args: &'a SweepArgs,
    template: &'a Template,
    points: &'a [Point],
    folder: &'a ResultsFolder,
    interrupt: &'a Interrupt,
    bar: ProgressBar,
    /// Number of cases of this shard.
    cases: usize,
    keys: Vec<String>,
    dynamic: bool,
    progress: Mutex<Reached>,
    start: Instant,
}

impl Sweep<'_> {
    /// Solves one case, unless the user asked to stop.
    fn solve(&self, case: usize) {
        if self.interrupt.asked() {
            return;
        }
        let ending = self
            .ending(&self.points[case])
            .unwrap_or_else(|why| Ending {
                solved: Vec::new(),
                why: Some(why),
            });
        let mut reached = lock(&self.progress);
        reached.endings[case] = Some(ending);
        reached.count += 1;
        self.bar.inc(1);
        let simulated_s = self.bar.position() as f64 * 1e-3;
        let speed = simulated_s / self.start.elapsed().as_secs_f64();
        self.bar.set_message(format!(
            "{} of {} cases, {speed:.0} × real time",
            reached.count, self.cases
        ));
        if reached.written.elapsed() >= WRITE_INTERVAL {
            // What cannot be written now is told at the end.
            let _ = self.write(&reached.endings);
            reached.written = Instant::now();
        }
    }

    fn ending(&self, point: &Point) -> Result<Ending, Stop> {
        let case = self
            .template
            .case(&point.changes)
            .map_err(|report| Stop::Unsolved(report.render(false)))?;
        let folder = ResultsFolder::create(self.folder.path().join(&point.name))?;
        let mut begun = None;
        if self.args.resume {
            if let Some(solved) = finished(folder.path(), &case) {
                // Killed between its last result and its end, a run may leave one.
                folder.remove_checkpoint()?;
                let simulated_s = Checked::of(&case).simulated_s;
                self.bar.inc(milliseconds(simulated_s));
                return Ok(Ending { solved, why: None });
            }
            begun = self.begun(point, &case, &folder);
        }
        let (mut record, under_way) = match begun {
            Some(begun) => begun,
            None => (Record::begin(&case, case.units, &folder)?, None),
        };
        let way = Way {
            csv: self.args.csv,
            checkpoint_every: self
                .args
                .checkpoint
                .unwrap_or_else(|| checkpoint_every(&case)),
            watch: Watch::Sweep(self.bar.clone()),
            interrupt: self.interrupt,
        };
        let why = solve(&case, &way, &mut record, &folder, under_way).err();
        Ok(Ending {
            solved: record.summary.operations,
            why,
        })
    }

    /// What an earlier sweep began of the case; nothing where it left none to go on with, or none that one can.
    fn begun(
        &self,
        point: &Point,
        case: &Case,
        folder: &ResultsFolder,
    ) -> Option<(Record, Option<UnderWay<'static>>)> {
        let begun = Laid::read(folder, case).and_then(|laid| {
            let Some(laid) = laid else { return Ok(None) };
            let record = Record::resume(case, case.units, folder, laid.solved)?;
            Ok(Some((record, laid.under_way)))
        });
        begun.unwrap_or_else(|reason| {
            Watch::Sweep(self.bar.clone()).tell(&format!(
                "warning: {}: {reason}; it begins anew\n",
                point.name
            ));
            None
        })
    }

    /// Writes `sweep.csv`: the cases in their order, as far as they have ended.
    fn write(&self, endings: &[Option<Ending>]) -> Result<(), Failure> {
        let mut table = SweepTable::new(self.keys.clone(), self.dynamic);
        for (point, ending) in self.points.iter().zip(endings) {
            if let Some(Ending { solved, why }) = ending {
                let failure = why.as_ref().and_then(Stop::reason);
                table.add(&point.values, &point.name, solved, failure.as_deref());
            }
        }
        let path = self.folder.path().join(FILE);
        Ok(table.table().write_csv(&path)?)
    }

    /// Writes table and page of all, and says how it went.
    fn conclude(self) -> Result<(), Failure> {
        let endings = std::mem::take(&mut lock(&self.progress).endings);
        self.write(&endings)?;
        report::write(self.folder, None)?;
        let place = self.folder.path().display();
        let mut finished = 0;
        let mut failed = Vec::new();
        for (point, ending) in self.points.iter().zip(&endings) {
            match ending {
                Some(Ending { why: None, .. }) => finished += 1,
                Some(Ending { why: Some(why), .. }) => failed.extend(
                    why.reason()
                        .map(|reason| format!("  {}: {reason}", point.name)),
                ),
                None => {}
            }
        }
        if !self.args.quiet {
            let took_s = self.start.elapsed().as_secs_f64();
            say(&format!(
                "{finished} of {} cases finished in {took_s:.1} s\nResults in {place}\n",
                self.cases
            ))?;
        }
        let failures = failed.join("\n");
        if self.interrupt.asked() && finished + failed.len() < self.cases {
            let failures = if failed.is_empty() {
                failures
            } else {
                failures + "\n"
            };
            return Err(Failure::Interrupted(format!(
                "{failures}interrupted: what was computed is in {place}\nto go on, run the sweep again with --resume"
            )));
        }
        if failed.is_empty() {
            return Ok(());
        }
        Err(Failure::Failed(format!(
            "error: {} of {} cases failed\n{failures}\nwhat was computed is in {place}",
            failed.len(),
            self.cases
        )))
    }
}

/// What a finished run of the case left in the folder; nothing if it is not finished, or of another case.
fn finished(folder: &Path, case: &Case) -> Option<Vec<OperationSummary>> {
    let summary = Summary::read(&folder.join("summary.json")).ok()?;
    let all = case.operations.len() * case.models.len();
    let complete = summary.operations.len() == all
        && summary
            .operations
            .iter()
            .all(|of| of.status == Status::Complete);
    (complete && difference(&summary.settings, &case.settings).is_none())
        .then_some(summary.operations)
}
