//! Solving a case, operation by operation, with whatever model it asks for.

use std::time::{Duration, Instant};

use wholestring::{
    dynamics::{
        BitLaw, DynamicsSettings, Effort as Planned, HoistControl, LiftError, MOST_LIFT_RUNS,
        SetupError, Simulation, TunedLift, tune_lift,
    },
    findings,
    operation::Operation,
    outcome::{ModelKind, Solution},
    statics::soft::{self, SoftSettings},
};
use wholestring_case::Case;
use wholestring_results::{ResultsFolder, Status};

use crate::{
    checkpoint::{self, Keeper, Laid, UnderWay},
    cores::Lent,
    failure::Failure,
    interrupt::Interrupt,
    keep::Keep,
    progress::{OwnBar, Watch},
    record::{CarriedOut, Effort, Record},
};

/// How a case is solved, beside what it says itself.
pub(crate) struct Way<'a> {
    /// What is kept of it.
    pub(crate) keep: Keep,
    /// Whether to write the tables as CSV too.
    pub(crate) csv: bool,
    /// Time on the clock between checkpoints.
    pub(crate) checkpoint_every: Duration,
    /// Who watches its progress.
    pub(crate) watch: Watch,
    pub(crate) interrupt: &'a Interrupt,
    /// Who works on solid rock.
    pub(crate) crew: Lent,
}

/// What the case says about the time between checkpoints.
pub(crate) fn checkpoint_every(case: &Case) -> Duration {
    Duration::from_secs_f64(case.checkpoint_interval_s)
}

/// Why a case was not solved to its end.
#[derive(Debug)]
pub(crate) enum Stop {
    /// The user asked.
    Interrupted,
    /// An operation has no answer or diverged: which, and why.
    Unsolved(String),
    /// The results could not be written.
    Unwritten(Failure),
}

impl Stop {
    /// Why the case failed; nothing where the user stopped it.
    pub(crate) fn reason(&self) -> Option<String> {
        match self {
            Self::Interrupted => None,
            Self::Unsolved(reason) => Some(reason.clone()),
            Self::Unwritten(failure) => Some(failure.to_string()),
        }
    }

    pub(crate) fn failure(self, folder: &ResultsFolder) -> Failure {
        let place = folder.path().display();
        match self {
            Self::Interrupted => {
                let how = if folder.has_checkpoint() {
                    format!("\nto go on, run the case with --resume {place}")
                } else {
                    String::new()
                };
                Failure::Interrupted(format!("interrupted: what was computed is in {place}{how}"))
            }
            Self::Unsolved(reason) => Failure::Failed(format!(
                "error: {reason}\nwhat was computed until then is in {place}"
            )),
            Self::Unwritten(failure) => failure,
        }
    }
}

impl<E: Into<Failure>> From<E> for Stop {
    fn from(error: E) -> Self {
        Self::Unwritten(error.into())
    }
}

/// Solves operation after operation, each with every model, and writes after each, so that whatever
/// comes between keeps what was solved. What the record has is solved already, but for one operation that
/// may be under way.
pub(crate) fn solve(
    case: &Case,
    way: &Way<'_>,
    record: &mut Record,
    folder: &ResultsFolder,
    mut under_way: Option<UnderWay>,
) -> Result<(), Stop> {
    let mut keeper = Keeper::new(folder, way.checkpoint_every);
    let mut written = false;
    for operation in &case.operations {
        for model in &case.models {
            if record.has(*model, operation) {
                continue;
            }
            if way.interrupt.asked() {
                lay_aside(&mut keeper, record, under_way, &way.watch);
                return Err(Stop::Interrupted);
            }
            let stopped = match model {
                ModelKind::Soft => solve_soft(case, operation, record),
                ModelKind::Dynamic => {
                    let begun = under_way.take_if(|begun| begun.is(operation));
                    solve_dynamic(case, operation, way, record, &mut keeper, begun)
                }
            };
            record.write(folder, way.keep, way.csv)?;
            written = true;
            match stopped {
                Status::Complete => {}
                Status::Interrupted => return Err(Stop::Interrupted),
                Status::Failed(reason) => {
                    keeper.finish()?;
                    record.finish(folder, way.keep)?;
                    return Err(Stop::Unsolved(format!(
                        "{}: {reason}",
                        operation.kind.name()
                    )));
                }
            }
            if keeper.is_due() {
                lay_aside(&mut keeper, record, None, &way.watch);
            }
        }
    }
    if !written {
        // All was solved when the run was laid aside; the folder may not show it.
        record.write(folder, way.keep, way.csv)?;
    }
    keeper.finish()?;
    record.finish(folder, way.keep)?;
    Ok(())
}

/// Writes a checkpoint. A run does not end because one cannot be written: the next may, and so may the
/// results.
fn lay_aside(keeper: &mut Keeper<'_>, record: &Record, under_way: Option<UnderWay>, watch: &Watch) {
    if let Err(error) = keeper.write(&Laid::new(record, under_way)) {
        watch.tell(&format!("warning: no checkpoint: {error}\n"));
    }
}

fn solve_soft(case: &Case, operation: &Operation, record: &mut Record) -> Status {
    match soft::solve(&case.model, operation, &SoftSettings::default()) {
        Ok(profile) => {
            record.add(operation, &Solution::from(&profile), CarriedOut::AT_ONCE);
            let found = findings::of_soft(&case.model, operation, &profile);
            record.judge(&found, &case.model.rig);
            Status::Complete
        }
        Err(error) => unsolvable("soft string", &error),
    }
}

/// Simulated time between two looks at Ctrl-C and two movements of the progress bar, s: a fraction of
/// a second even where a run is slower than real time.
const LOOK_INTERVAL_S: f64 = 0.2;

fn solve_dynamic(
    case: &Case,
    operation: &Operation,
    way: &Way<'_>,
    record: &mut Record,
    keeper: &mut Keeper<'_>,
    begun: Option<UnderWay>,
) -> Status {
    let start = Instant::now();
    let mut before = Duration::ZERO;
    let mut lift = begun.as_ref().and_then(|begun| begun.lift);
    let mut settings = case.dynamics.clone();
    let mut tuned = None;
    if case.tunes_lift && lift.is_none() {
        match tune(case, operation, way) {
            Ok((found, simulation)) => {
                lift = Some(found);
                // Frames are taken as a run goes on: that needs another.
                tuned = record.frames.is_none().then_some(simulation);
            }
            Err(LiftError::Stopped) => {
                lay_aside(keeper, record, None, &way.watch);
                return Status::Interrupted;
            }
            Err(error) => return unsolvable("dynamic model", &error),
        }
    }
    if let Some(lift) = lift {
        settings.hoist_control = Some(HoistControl::HookLoad(lift.hook_load_N));
    }
    let run_again = lift.is_some() && tuned.is_none();
    let mut simulation = match (begun, tuned) {
        (None, Some(tuned)) => tuned,
        (None, None) => {
            let what = preparation(&settings, operation);
            let _shown = way.watch.preparing(operation.kind.name(), what);
            let crew = way.crew.clone();
            match Simulation::lent(&case.model, operation, &settings, crew) {
                Ok(simulation) => simulation,
                Err(SetupError::Stopped) => {
                    lay_aside(keeper, record, None, &way.watch);
                    return Status::Interrupted;
                }
                Err(error) => return unsolvable("dynamic model", &error),
            }
        }
        (Some(begun), _) => {
            before = Duration::from_secs_f64(begun.wall_time_s);
            let then = begun.simulation.instructions().to_owned();
            let resumed = Simulation::resume(&case.model, operation, &settings, begun.simulation);
            match resumed {
                Ok(simulation) => {
                    let now = simulation.instructions();
                    if let Some(warning) = checkpoint::other_processor(&then, now) {
                        way.watch.tell(&warning);
                    }
                    simulation
                }
                Err(error) => return unsolvable("dynamic model", &error),
            }
        }
    };
    // One that was resumed has not got them yet.
    simulation.lend(way.crew.clone());
    let took = || before + start.elapsed();
    // Laying the string takes seconds. Whoever has asked by now has nothing of this operation to keep.
    if way.interrupt.asked() && simulation.time_s() == 0.0 {
        lay_aside(keeper, record, None, &way.watch);
        return Status::Interrupted;
    }
    let waits = settings.steady.is_some();
    let name = operation.kind.name();
    let longest_s = match Planned::of(&case.model, operation, &settings) {
        Ok(effort) => effort.end_s,
        Err(_) => simulation.end_time_s(),
    };
    let progress = way.watch.operation(name, simulation.time_s(), longest_s);
    // The run goes on by whole samples.
    let sample_s = simulation.sample_interval_s();
    let frame_samples = record
        .frames
        .as_ref()
        .map(|frames| frames.samples(sample_s));
    let look_samples = ((LOOK_INTERVAL_S / sample_s).round() as u64).max(1);
    // Frames and looks fall on the same samples wherever the run was taken up.
    let mut samples = (simulation.time_s() / sample_s).round() as u64;
    let status = loop {
        let (time_s, end_s) = (simulation.time_s(), simulation.end_time_s());
        progress.ends(end_s, waits && simulation.is_settling());
        progress.reach(time_s);
        if time_s >= end_s - 0.5 * sample_s {
            break Status::Complete;
        }
        let interrupted = way.interrupt.asked();
        if interrupted || keeper.is_due() {
            let under_way = UnderWay::new(operation, took(), lift, simulation.checkpoint());
            lay_aside(keeper, record, Some(under_way), &way.watch);
        }
        if interrupted {
            break Status::Interrupted;
        }
        let missing = ((end_s - time_s) / sample_s).round() as u64;
        let to_frame = frame_samples.map_or(u64::MAX, |every| every - samples % every);
        let next = look_samples.min(missing.max(1)).min(to_frame);
        if let Err(diverged) = simulation.advance(next as f64 * sample_s) {
            break Status::Failed(diverged.to_string());
        }
        samples += next;
        if next == to_frame
            && let Some(frames) = &mut record.frames
            && let Err(error) = frames.take(operation, &simulation)
        {
            break Status::Failed(error.to_string());
        }
    };
    progress.finish();
    let effort = Effort {
        took: took(),
        runs: lift.map_or(1, |lift| lift.runs + usize::from(run_again)),
    };
    let outcome = simulation.outcome();
    let bottom = simulation.bottom_hole();
    let carried_out = CarriedOut {
        status: status.clone(),
        lift,
        bottom: bottom.as_ref(),
        effort,
    };
    record.add(operation, &Solution::from(&outcome), carried_out);
    // What was not computed to its end has said so already.
    if status == Status::Complete {
        let found = findings::of_dynamic(&case.model, operation, &settings, &outcome);
        record.judge(&found, &case.model.rig);
    }
    status
}

/// What is done before an operation's first step.
fn preparation(settings: &DynamicsSettings, operation: &Operation) -> &'static str {
    match settings.bit.law {
        BitLaw::Rock(_) if operation.weight_on_bit_now_N() > 0.0 => {
            "laying the string and running the bit in on the rock"
        }
        _ => "laying the string",
    }
}

/// Finds the lift of an operation, and its run under it.
fn tune(
    case: &Case,
    operation: &Operation,
    way: &Way<'_>,
) -> Result<(TunedLift, Simulation), LiftError> {
    let mut bar: Option<(usize, OwnBar)> = None;
    let (model, settings) = (&case.model, &case.dynamics);
    let found = tune_lift(model, operation, settings, &way.crew, |run, simulation| {
        if bar.as_ref().is_none_or(|(of, _)| *of != run) {
            let name = format!(
                "{}, lift {run} of at most {MOST_LIFT_RUNS}",
                operation.kind.name()
            );
            if let Some((_, bar)) = bar.take() {
                bar.clear();
            }
            bar = way
                .watch
                .trial(&name, simulation.end_time_s())
                .map(|own| (run, own));
        }
        if let Some((_, bar)) = &bar {
            let settles = case.dynamics.steady.is_some() && simulation.is_settling();
            bar.ends(simulation.end_time_s(), settles);
            bar.reach(simulation.time_s());
        }
        !way.interrupt.asked()
    });
    if let Some((_, bar)) = bar {
        bar.clear();
    }
    found
}

fn unsolvable(model: &str, error: &dyn std::error::Error) -> Status {
    Status::Failed(format!("the {model} has no answer: {error}"))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use wholestring_units::UnitSet;

    use super::*;
    use crate::cores;

    /// A model that the CLI's own test data describe.
    fn slant() -> Case {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/slant.toml");
        wholestring_case::load(&path, &[]).expect("a sound case")
    }

    #[test]
    fn who_interrupts_the_laying_does_not_wait_for_the_run() {
        let case = slant();
        let place = tempfile::tempdir().expect("a folder");
        let folder = ResultsFolder::create(place.path()).expect("a folder");
        let mut record = Record::begin(&case, UnitSet::Si, &folder).expect("a record");
        let asked = Interrupt::already_asked();
        let status = solve_dynamic(
            &case,
            &case.operations[0],
            &way(&asked),
            &mut record,
            &mut Keeper::new(&folder, Duration::MAX),
            None,
        );
        assert_eq!(status, Status::Interrupted);
        assert!(record.summary.operations.is_empty());
    }

    #[test]
    fn what_comes_before_the_first_step_is_said() {
        let case = slant();
        let said = preparation(&case.dynamics, &case.operations[0]);
        assert_eq!(said, "laying the string");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/rock-300.toml");
        let case = wholestring_case::load(&path, &[]).expect("a sound case");
        let said = preparation(&case.dynamics, &case.operations[0]);
        assert!(said.ends_with("running the bit in on the rock"), "{said}");
    }

    /// An operation without an answer ends like one that diverged: what was solved before is kept, and
    /// the message says where.
    #[test]
    fn an_operation_without_answer_keeps_what_was_solved() {
        let mut case = slant();
        // Deeper than the string is long, which no case file gets past its checks.
        case.operations[1].bit_depth_m += 100.0;
        let place = tempfile::tempdir().expect("a folder");
        let folder = ResultsFolder::create(place.path()).expect("a folder");
        for (model, kept) in [(ModelKind::Soft, 1), (ModelKind::Dynamic, 0)] {
            case.models = vec![model];
            // What an earlier run left does not pass for this one's.
            if model == ModelKind::Dynamic {
                case.operations.remove(0);
            }
            let mut record = Record::begin(&case, UnitSet::Si, &folder).expect("a record");
            let asked = Interrupt::never();
            let stop = solve(&case, &way(&asked), &mut record, &folder, None).unwrap_err();
            let failure = stop.failure(&folder);
            assert_eq!(failure.status(), 3);
            let message = failure.to_string();
            assert!(message.contains("has no answer: "), "{message}");
            let end = format!(
                "what was computed until then is in {}",
                place.path().display()
            );
            assert!(message.ends_with(&end), "{message}");
            let summary = place.path().join("summary.json");
            let summary = wholestring_results::Summary::read(&summary).expect("a summary");
            assert_eq!(summary.operations.len(), kept);
        }
    }

    fn way(interrupt: &Interrupt) -> Way<'_> {
        Way {
            keep: Keep::All,
            csv: false,
            checkpoint_every: Duration::MAX,
            watch: Watch::Screen { quiet: true },
            interrupt,
            crew: cores::alone(interrupt),
        }
    }
}
