//! Sets of cases that are solved together: all cores, one progress bar.

use std::{
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
    time::{Duration, Instant},
};

use indicatif::ProgressBar;
use wholestring_case::Case;
use wholestring_contain::{Panicked, contain};
use wholestring_results::{Occupant, OperationSummary, ResultsFolder, Status, Summary, digest};

use super::{
    checked::{Checked, check},
    points::Point,
    report,
    table::{FILE, SweepTable},
};
use crate::{
    args::{BatchArgs, Shard},
    checkpoint::{Laid, UnderWay, is_of},
    claim::{Claim, Claimed},
    conclusion::Conclusion,
    cores,
    failure::Failure,
    findings,
    folder_name::default_output,
    interrupt::Interrupt,
    keep::Keep,
    pace::pace,
    parallel::{in_parallel, lock},
    progress::{self, Watch, milliseconds},
    record::Record,
    report as page, say,
    solve::{Stop, Way, checkpoint_every, solve},
};

/// Time between two writings of a `sweep.csv` while its cases are solved.
const WRITE_INTERVAL: Duration = Duration::from_secs(5);

/// Cases with a folder and a table of their own.
pub(crate) struct Set {
    /// What stands before the names of its cases in messages.
    pub(crate) prefix: String,
    pub(crate) folder: ResultsFolder,
    /// The keys that are varied.
    pub(crate) keys: Vec<String>,
    /// What the user asks to keep of each case.
    pub(crate) keep: Option<Keep>,
    /// What at least is read again.
    pub(crate) needs: Keep,
}

impl Set {
    /// What is kept of a case.
    fn keep(&self, case: &Case, csv: bool) -> Keep {
        let keep = self.keep.unwrap_or_else(|| Keep::of_itself(case, csv));
        keep.max(self.needs)
    }
}

/// How a case ended.
pub(crate) struct Ending {
    pub(crate) solved: Vec<OperationSummary>,
    /// Nothing where it is finished.
    pub(crate) why: Option<Stop>,
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
    /// What it is called on the bar and in messages: `sweep`.
    noun: &'static str,
    args: &'a BatchArgs,
    sets: Vec<Set>,
    points: Vec<Point<'a>>,
    checked: Vec<Checked>,
    interrupt: Interrupt,
    bar: ProgressBar,
    /// The cases of this shard.
    mine: Vec<usize>,
    progress: Mutex<Reached>,
    start: Instant,
}

/// The cases of a batch, read and checked, with the name of the first.
pub(crate) struct Sound<'a> {
    points: Vec<Point<'a>>,
    checked: Vec<Checked>,
}

impl<'a> Sound<'a> {
    /// Reads and checks every case, so that no batch ends on a mistake in its last.
    pub(crate) fn check(points: Vec<Point<'a>>, args: &BatchArgs) -> Result<Self, Failure> {
        let checked = check(&points, args.jobs(), args.quiet)?;
        Ok(Self { points, checked })
    }

    /// What the first case is called.
    pub(crate) fn first_name(&self) -> &str {
        self.checked.first().map_or("", |case| &case.name)
    }

    /// Digest of all that the answers depend on: those of all cases, by set and name.
    fn identity(&self) -> String {
        let cases = self.points.iter().zip(&self.checked);
        let cases = cases.map(|(point, case)| (point.set, &point.name, &case.identity));
        digest(&cases.collect::<Vec<_>>())
    }

    /// The folder for a batch, which is called so; a case of the numbered set goes to what `within` makes of the batch's folder.
    pub(crate) fn claim(
        &self,
        kind: &str,
        name: &str,
        args: &BatchArgs,
        within: &dyn Fn(&Path, usize) -> PathBuf,
    ) -> Result<Claimed, Failure> {
        let shard = args.shard.unwrap_or(Shard::ALL);
        let mine = || {
            let cases = self.points.iter().enumerate();
            cases.filter_map(|(case, point)| shard.has(case).then_some(point))
        };
        let case = |path: &Path, point: &Point<'_>| within(path, point.set).join(&point.name);
        Claim {
            occupant: Occupant {
                kind: kind.to_owned(),
                name: name.to_owned(),
                identity: self.identity(),
            },
            output: args.output.as_deref(),
            default: default_output(name),
            shared: shard != Shard::ALL,
            resume: args.resume,
            overwrite: args.overwrite,
            quiet: args.quiet,
            is_unfinished: &|path| {
                mine().any(|point| case(path, point).join("checkpoint.bin").is_file())
            },
            is_part: &|path| self.points.iter().any(|point| case(path, point).is_dir()),
            go_on: &|_| "add --resume".to_owned(),
            refuse: &|_| Ok(()),
        }
        .folder()
    }
}

impl<'a> Batch<'a> {
    /// A batch of sound cases that belong to these sets.
    pub(crate) fn new(
        noun: &'static str,
        args: &'a BatchArgs,
        sets: Vec<Set>,
        sound: Sound<'a>,
    ) -> Self {
        let Sound { points, checked } = sound;
        let shard = args.shard.unwrap_or(Shard::ALL);
        let mine: Vec<usize> = (0..points.len()).filter(|case| shard.has(*case)).collect();
        // Besides its simulated time, a case counts as one millisecond on the bar, so that soft strings move
        // it too.
        let lengths = mine
            .iter()
            .map(|case| 1 + milliseconds(checked[*case].simulated_s));
        let bar = progress::bar(lengths.sum(), args.quiet);
        bar.set_prefix(noun);
        Self {
            noun,
            args,
            sets,
            interrupt: Interrupt::listen(),
            bar,
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
    pub(crate) fn solve_all(&mut self) -> Result<(), Failure> {
        // The longest first: what is left at the end is short, and no thread waits long for the others.
        let mut order = self.mine.clone();
        order.sort_by(|a, b| self.checked[*b].cost.total_cmp(&self.checked[*a].cost));
        in_parallel(self.args.jobs(), &order, |case| self.solve(case));
        self.bar.finish_and_clear();
        let reached = lock(&self.progress);
        (0..self.sets.len()).try_for_each(|set| {
            self.write(set, &reached.endings)?;
            Ok(report::write(&self.sets[set].folder, None)?)
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

    /// Solves one case, unless the user asked to stop.
    fn solve(&self, case: usize) {
        if self.interrupt.asked() {
            return;
        }
        // A mistake of the program in one case is no reason to lose the others.
        let ending = contain(|| self.ending(case))
            .unwrap_or_else(|Panicked(mistake)| {
                Err(Stop::Unsolved(format!(
                    "a mistake of the program, please report it: {mistake}"
                )))
            })
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
            "{} of {} cases, {}",
            reached.count,
            self.mine.len(),
            pace(speed)
        ));
        if reached.written.elapsed() >= WRITE_INTERVAL {
            // What cannot be written now is told at the end.
            let _ = self.write(self.points[case].set, &reached.endings);
            reached.written = Instant::now();
        }
    }

    fn ending(&self, case: usize) -> Result<Ending, Stop> {
        let (point, checked) = (&self.points[case], &self.checked[case]);
        let case = match checked.take() {
            Some(case) => case,
            None => point
                .template
                .case(&point.changes)
                .map_err(|report| Stop::Unsolved(report.render(false)))?,
        };
        let folder = ResultsFolder::create(self.folder(point))?;
        let keep = self.sets[point.set].keep(&case, self.args.csv);
        let mut begun = None;
        if self.args.resume {
            match finished(folder.path(), &case, keep) {
                Ok(Some(solved)) => {
                    // Killed between its last result and its end, a run may leave one.
                    folder.remove_checkpoint()?;
                    if keep == Keep::All {
                        page::complete(&folder, case.units)?;
                    }
                    self.bar.inc(milliseconds(checked.simulated_s));
                    return Ok(Ending { solved, why: None });
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
            csv: self.args.csv,
            checkpoint_every: self
                .args
                .checkpoint
                .unwrap_or_else(|| checkpoint_every(&case)),
            watch: Watch::Sweep(self.bar.clone()),
            interrupt: &self.interrupt,
            // Cases are what the cores share.
            crew: cores::alone(&self.interrupt),
        };
        let why = solve(&case, &way, &mut record, &folder, under_way).err();
        if keep == Keep::All {
            page::write(&folder, case.units)?;
        }
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
        let begun = Laid::<'static>::read(folder, case).and_then(|laid| {
            let Some(laid) = laid else { return Ok(None) };
            let record = Record::resume(case, case.units, folder, laid.solved)?;
            Ok(Some((record, laid.under_way)))
        });
        begun.unwrap_or_else(|reason| {
            self.warn_of(point, &reason);
            None
        })
    }

    /// Tells why a case does not go on from what lies in its folder.
    fn warn_of(&self, point: &Point<'_>, reason: &str) {
        let label = self.label(point);
        let warning = format!("warning: {label}: {reason}; it begins anew\n");
        Watch::Sweep(self.bar.clone()).tell(&warning);
    }

    /// The folder of a case.
    pub(crate) fn folder(&self, point: &Point<'_>) -> PathBuf {
        self.sets[point.set].folder.path().join(&point.name)
    }

    /// What messages call a case.
    fn label(&self, point: &Point<'_>) -> String {
        format!("{}{}", self.sets[point.set].prefix, point.name)
    }

    /// Writes a set's `sweep.csv`: its cases in their order, as far as they have ended.
    fn write(&self, set: usize, endings: &[Option<Ending>]) -> Result<(), Failure> {
        let of_set = |case: &usize| self.points[*case].set == set;
        let cases = || (0..self.points.len()).filter(of_set);
        let dynamic = cases().any(|case| self.checked[case].simulated_s > 0.0);
        let lift = cases().any(|case| self.checked[case].lift);
        let mut table = SweepTable::new(self.sets[set].keys.clone(), dynamic, lift);
        for case in cases() {
            if let Some(Ending { solved, why }) = &endings[case] {
                let failure = why.as_ref().and_then(Stop::reason);
                let point = &self.points[case];
                table.add(&point.values, &point.name, solved, failure.as_deref());
            }
        }
        let path = self.sets[set].folder.path().join(FILE);
        Ok(table.table().write_csv(&path)?)
    }

    /// Says how it went; its results are in `place`. If it is strict, no error may have been found.
    pub(crate) fn conclude(self, place: &Path, strict: bool) -> Result<(), Failure> {
        let endings = std::mem::take(&mut lock(&self.progress).endings);
        let (noun, cases) = (self.noun, self.mine.len());
        let mut finished = 0;
        let mut failed = Vec::new();
        let mut wrong = Vec::new();
        for (point, ending) in self.points.iter().zip(&endings) {
            match ending {
                Some(Ending { why: None, .. }) => finished += 1,
                Some(Ending { why: Some(why), .. }) => failed.extend(
                    why.reason()
                        .map(|reason| format!("  {}: {reason}", self.label(point))),
                ),
                None => {}
            }
            let solved = ending.iter().flat_map(|ending| &ending.solved);
            let found = solved.filter(|of| findings::is_wrong(of));
            let found: Vec<String> = found.map(findings::name).collect();
            if !found.is_empty() {
                wrong.push(format!("  {}: {}", self.label(point), found.join(", ")));
            }
        }
        Conclusion {
            noun,
            items: "cases",
            all: cases,
            finished,
            failed,
            interrupted: self.interrupt.asked(),
            place,
            took: self.start.elapsed(),
        }
        .tell(self.args.quiet)?;
        if wrong.is_empty() {
            return Ok(());
        }
        let found = wrong.len();
        if strict {
            let wrong = wrong.join("\n");
            return Err(Failure::Refused(format!(
                "error: errors were found in {found} of {cases} cases\n{wrong}"
            )));
        }
        if self.args.quiet {
            return Ok(());
        }
        say(&format!(
            "Errors were found in {found} of {cases} cases: see {FILE}\n"
        ))
    }
}

/// What a finished run of the case left in the folder; nothing if there is none, it is not finished, or has
/// not kept what is to be kept.
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
        && summary
            .operations
            .iter()
            .all(|of| of.status == Status::Complete);
    Ok((complete && keep.has_tables(folder)).then_some(summary.operations))
}
