//! Solution of a case, operation by operation, with the models that it requires.

use std::time::Duration;

use wholestring::{
    dynamics::{
        BitLaw, DynamicOutcome, DynamicsSettings, Effort as Planned, HoistControl, MAX_TUNING_RUNS,
        SetupError, Simulation, TunedHookLoad, TuningError, tune_hook_load,
    },
    operation::Operation,
    outcome::{ModelKind, Solution},
    statics::{
        soft,
        stiff::{self, StiffError},
    },
};
use wholestring_case::Case;
use wholestring_judge::NoAnswer;
use wholestring_results::{ResultsFolder, Status};

use super::way::{Stop, Way};
use crate::{
    checkpoint::{Keeper, RunCheckpoint, UnderWay, other_arithmetic},
    clock::Instant,
    observer::{Simulating, Trial, Watch},
    pace::Pace,
    parallel::beside,
    record::{
        HandedOver, Record,
        rows::{CarriedOut, Effort},
    },
};

/// Solves each operation with every model, and writes after each, so that an interruption keeps the
/// results so far. Operations in the record are already solved; one may be under way. If a static
/// model has no solution for an operation, the run ends with an error after the others are solved;
/// if a dynamic one diverges, it ends at once. Without a folder all results remain in the record.
pub(crate) fn solve(
    case: &Case,
    way: &Way<'_>,
    record: &mut Record,
    folder: Option<&ResultsFolder>,
    mut under_way: Option<UnderWay>,
) -> Result<(), Stop> {
    let mut keeper = match folder {
        Some(folder) => Keeper::new(folder, way.checkpoint_every),
        None => Keeper::in_memory(),
    };
    let write = |record: &mut Record| match folder {
        Some(folder) => record.write(folder, way.keep, way.csv),
        None => Ok(()),
    };
    let finish = |record: &Record| match folder {
        Some(folder) => record.finish(folder, way.keep),
        None => Ok(()),
    };
    let mut written = false;
    for operation in &case.operations {
        for model in &case.models {
            if record.has(*model, operation) {
                continue;
            }
            if way.cancellation.is_cancelled() {
                write_checkpoint(&mut keeper, record, under_way, &way.watch);
                return Err(Stop::Interrupted);
            }
            let stopped = match model {
                ModelKind::Soft => {
                    solve_soft(case, operation, record);
                    Status::Complete
                }
                ModelKind::Stiff => {
                    solve_stiff(case, operation, record);
                    Status::Complete
                }
                ModelKind::Dynamic => {
                    let begun = under_way.take_if(|begun| begun.is(operation));
                    solve_dynamic(case, operation, way, record, &mut keeper, begun)
                }
            };
            write(record)?;
            written = true;
            match stopped {
                Status::Complete => {}
                Status::Interrupted => return Err(Stop::Interrupted),
                Status::Failed(reason) => {
                    keeper.finish()?;
                    finish(record)?;
                    return Err(Stop::Unsolved(format!("{}: {reason}", operation.kind.name())));
                }
            }
            if keeper.is_due() {
                write_checkpoint(&mut keeper, record, None, &way.watch);
            }
        }
    }
    if !written {
        // All was solved when the checkpoint was written, but the results in the folder may be
        // incomplete.
        write(record)?;
    }
    keeper.finish()?;
    finish(record)?;
    // Includes operations without a solution from a checkpoint.
    record.unsolved().map_or(Ok(()), |reasons| Err(Stop::Unsolved(reasons)))
}

/// Writes a checkpoint. The run continues if it cannot be written, because the next one and the
/// results may succeed.
fn write_checkpoint(
    keeper: &mut Keeper<'_>,
    record: &Record,
    under_way: Option<UnderWay>,
    watch: &Watch<'_>,
) {
    if let Err(error) = keeper.write(&RunCheckpoint::new(record, under_way)) {
        let warning = format!("no checkpoint: {error}");
        watch.observer.warning(&warning);
    }
}

fn solve_soft(case: &Case, operation: &Operation, record: &mut Record) {
    match soft::solve(&case.model, operation, &case.soft) {
        Ok(profile) => {
            record.add(operation, &Solution::from(&profile), CarriedOut::AT_ONCE);
            record.judged(record.judge(case).soft(&case.model, operation, &profile));
        }
        Err(error) => add_unsolved(case, ModelKind::Soft, operation, &error.into(), record),
    }
}

fn solve_stiff(case: &Case, operation: &Operation, record: &mut Record) {
    match stiff::solve(&case.model, operation, &case.dynamics.stiff_string()) {
        Ok(profile) => {
            record.add(operation, &Solution::from(&profile), CarriedOut::AT_ONCE);
            record.judged(record.judge(case).stiff(&case.model, operation, &profile));
        }
        Err(error) => add_unsolved(case, ModelKind::Stiff, operation, &error.into(), record),
    }
}

/// Records an operation without an equilibrium: its verdict, whose sentence is also the reason.
fn add_unsolved(
    case: &Case,
    model: ModelKind,
    operation: &Operation,
    why: &NoAnswer,
    record: &mut Record,
) {
    let soft = match why {
        NoAnswer::Stiff(StiffError::NotConverged { .. }) => {
            soft::solve(&case.model, operation, &case.soft).ok()
        }
        _ => None,
    };
    let judge = record.judge(case);
    let checks = judge.unsolved_beside(why, &case.model, operation, soft.as_ref());
    let sentences = checks.checks.iter().map(|check| check.sentence.as_str());
    let sentence = sentences.collect::<Vec<_>>().join("; ");
    let reason = format!("the {} string has no answer: {sentence}", model.name());
    record.add_unsolved(model, operation, reason);
    record.judged(checks);
}

/// Longest simulated time between two checks for cancellation and two progress reports, s; a slow
/// run checks by wall-clock time.
const POLL_INTERVAL_S: f64 = 0.2;

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
    if case.tunes_hook_load && lift.is_none() {
        match tune(case, operation, way) {
            Ok((found, simulation)) => {
                lift = Some(found);
                // Frames are taken while a run continues, so they require another run.
                tuned = record.frames.is_none().then_some(simulation);
            }
            Err(TuningError::Stopped) => {
                write_checkpoint(keeper, record, None, &way.watch);
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
            let executor = way.executor.clone();
            match Simulation::with_executor(&case.model, operation, &settings, executor) {
                Ok(simulation) => simulation,
                Err(SetupError::Stopped) => {
                    write_checkpoint(keeper, record, None, &way.watch);
                    return Status::Interrupted;
                }
                Err(error) => return unsolvable("dynamic model", &error),
            }
        }
        (Some(begun), _) => {
            before = Duration::from_secs_f64(begun.wall_time_s);
            let then = begun.simulation.is_fused();
            let resumed = Simulation::resume(&case.model, operation, &settings, begun.simulation);
            match resumed {
                Ok(simulation) => {
                    if let Some(warning) = other_arithmetic(then, simulation.is_fused()) {
                        way.watch.observer.warning(warning);
                    }
                    simulation
                }
                Err(error) => return unsolvable("dynamic model", &error),
            }
        }
    };
    // A resumed run has no executor yet.
    simulation.set_executor(way.executor.clone());
    let took = || before + start.elapsed();
    if simulation.handed_over() > 0
        && let Err(reason) = handed_over(keeper.folder(), record, &simulation)
    {
        return Status::Failed(reason);
    }
    // Initialising the string takes seconds; after a cancellation in that time there is no result
    // of this operation to keep.
    if way.cancellation.is_cancelled() && simulation.time_s() == 0.0 {
        write_checkpoint(keeper, record, None, &way.watch);
        return Status::Interrupted;
    }
    let waits = settings.steady.is_some();
    let name = operation.kind.name();
    let longest_s = match Planned::of(&case.model, operation, &settings) {
        Ok(effort) => effort.end_s,
        Err(_) => simulation.end_time_s(),
    };
    let times = [simulation.time_s(), longest_s];
    let progress = way.watch.simulation(name, None, times);
    // The run continues by whole samples; a run on rock that was stopped within a sample first
    // completes it.
    let sample_s = simulation.sample_interval_s();
    let frame_samples = record.frames.as_ref().map(|frames| frames.samples(sample_s));
    let mut pace = Pace::new(POLL_INTERVAL_S, sample_s);
    let status = loop {
        if let Some(folder) = keeper.folder()
            && let Err(error) = record.take_rows(folder, operation, &mut simulation)
        {
            break Status::Failed(error.to_string());
        }
        let (time_s, end_s) = (simulation.time_s(), simulation.end_time_s());
        progress.reach(time_s, end_s, waits && simulation.is_settling());
        let samples = simulation.samples();
        let missing = ((end_s / sample_s - 0.5).ceil() as u64).saturating_sub(samples);
        if missing == 0 {
            break Status::Complete;
        }
        if way.cancellation.is_cancelled() {
            break Status::Interrupted;
        }
        if keeper.is_due() {
            let under_way = UnderWay::new(operation, took(), lift, simulation.checkpoint());
            write_checkpoint(keeper, record, Some(under_way), &way.watch);
        }
        // Frames are at the same samples wherever the run was resumed.
        let to_frame = frame_samples.map_or(u64::MAX, |every| every - samples % every);
        let advanced =
            pace.work(missing.min(to_frame), |next| simulation.advance(next as f64 * sample_s));
        if let Err(diverged) = advanced {
            break Status::Failed(diverged.to_string());
        }
        if simulation.samples() - samples == to_frame
            && let Some(frames) = &mut record.frames
            && let Err(error) = frames.take(operation, &simulation)
        {
            break Status::Failed(error.to_string());
        }
    };
    drop(progress);
    let effort =
        Effort { took: took(), runs: lift.map_or(1, |lift| lift.runs + usize::from(run_again)) };
    let earlier = match handed_over(keeper.folder(), record, &simulation) {
        Ok(earlier) => earlier,
        Err(reason) => return Status::Failed(reason),
    };
    let outcome = if status == Status::Interrupted {
        outcome_beside(&simulation, &earlier, || {
            let under_way = UnderWay::new(operation, took(), lift, simulation.checkpoint());
            write_checkpoint(keeper, record, Some(under_way), &way.watch);
        })
    } else {
        simulation.outcome_with(&earlier)
    };
    let bottom = simulation.bottom_hole();
    let carried_out = CarriedOut { status: status.clone(), lift, bottom: bottom.as_ref(), effort };
    let solution = Solution::from(&outcome).with_earlier(Some(&earlier));
    record.add(operation, &solution, carried_out);
    // Incomplete operations have reported this already.
    if status == Status::Complete {
        let judge = record.judge(case);
        record.judged(judge.dynamic(&case.model, operation, &settings, &solution));
    }
    match earlier.fault() {
        Some(reason) if status == Status::Complete => {
            record.failed(reason.clone());
            Status::Failed(reason)
        }
        _ => status,
    }
}

/// Rows that a simulation has moved to the disk; empty for a run in memory.
fn handed_over(
    folder: Option<&ResultsFolder>,
    record: &Record,
    simulation: &Simulation,
) -> Result<HandedOver, String> {
    match folder {
        Some(folder) => record.handed_over(folder, simulation),
        None => Ok(HandedOver::none()),
    }
}

/// Results of a run, computed while other work is done; an interruption waits for both.
fn outcome_beside(
    simulation: &Simulation,
    earlier: &HandedOver,
    other: impl FnOnce(),
) -> DynamicOutcome {
    beside(|| simulation.outcome_with(earlier), other).0
}

/// Description of the preparation before an operation's first step.
fn preparation(settings: &DynamicsSettings, operation: &Operation) -> &'static str {
    match settings.bit.law {
        BitLaw::Rock(_) if operation.weight_on_bit_now_N() > 0.0 => {
            "initialising the string and running the bit in on the rock"
        }
        _ => "initialising the string",
    }
}

fn unsolvable(model: &str, error: &dyn std::error::Error) -> Status {
    Status::Failed(no_answer(model, error))
}

pub(super) fn no_answer(model: &str, error: &dyn std::error::Error) -> String {
    format!("the {model} has no answer: {error}")
}

// Search of the lift of a string that hangs on the hoist.

/// Simulated time between two progress reports, s.
const SHOW_INTERVAL_S: f64 = 0.2;

/// Finds the lift of an operation, and its run with it.
fn tune(
    case: &Case,
    operation: &Operation,
    way: &Way<'_>,
) -> Result<(TunedHookLoad, Simulation), TuningError> {
    let mut report: Option<(usize, Simulating<'_>)> = None;
    let mut shown_s = f64::NEG_INFINITY;
    let (model, settings) = (&case.model, &case.dynamics);
    tune_hook_load(model, operation, settings, &way.executor, |run, simulation| {
        if report.as_ref().is_none_or(|(trial, _)| *trial != run) {
            let trial = Trial { number: run, most: MAX_TUNING_RUNS };
            let times = [0.0, simulation.end_time_s()];
            // Ends the report of the previous trial.
            report = None;
            let name = operation.kind.name();
            report = Some((run, way.watch.simulation(name, Some(trial), times)));
            shown_s = f64::NEG_INFINITY;
        }
        if let Some((_, report)) = &report
            && simulation.time_s() >= shown_s + SHOW_INTERVAL_S
        {
            shown_s = simulation.time_s();
            let settling = settings.steady.is_some() && simulation.is_settling();
            report.reach(simulation.time_s(), simulation.end_time_s(), settling);
        }
        !way.cancellation.is_cancelled()
    })
}

#[cfg(test)]
mod tests;
