//! Dynamic simulations with the fitted parameters, compared with some of the readings.

use std::{num::NonZeroUsize, sync::Mutex};

use wholestring::{
    dynamics::{DynamicsSettings, Effort, Schedule, Simulation},
    model::Model,
    operation::Operation,
};
use wholestring_judge::Quantity;
use wholestring_plan::calibration::{Calibration, Channel, Motion, Point};
use wholestring_results::{DynamicCheck, InMotion};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    cancellation::CancellationToken,
    cores,
    error::Error,
    observer::{BatchSize, CaseEnded, Observer, Watch},
    pace::Pace,
    parallel::{in_parallel, jobs, lock},
    readings::{NamedCase, Readings},
};

/// Depths of readings at which the dynamic simulation is run.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckDynamics {
    /// Depths of the bit, m; if empty, the shallowest, middle and deepest of the fit.
    pub bit_depths_m: Vec<f64>,
    /// Number of parallel jobs; one per core by default.
    pub jobs: Option<NonZeroUsize>,
}

/// Largest distance of a given depth from that of a reading, m, because depths are written in whole
/// feet.
const SAME_DEPTH_M: f64 = 0.5;

/// Longest simulated time between two checks for cancellation, s.
const POLL_INTERVAL_S: f64 = 0.2;

/// A motion of a string with its bit at a depth.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Run {
    setup: usize,
    bit_depth_m: f64,
    motion: Motion,
}

/// Loads of a moving string: hook load and torque, mean and standard deviation of each.
#[derive(Debug, Clone, Copy)]
struct Moved {
    hook_load_N: [f64; 2],
    torque_N_m: [f64; 2],
    mean_bit_depth_m: f64,
    steady: Option<bool>,
}

/// The strings and depths to simulate.
pub(super) fn chosen(
    check: &CheckDynamics,
    data: &Readings,
    units: UnitSet,
) -> Result<Vec<(usize, f64)>, Error> {
    let mut all: Vec<(usize, f64)> = Vec::new();
    for reading in data.readings.iter().chain(&data.held_out) {
        if !all.contains(&(reading.setup, reading.bit_depth_m)) {
            all.push((reading.setup, reading.bit_depth_m));
        }
    }
    all.sort_by(|a, b| a.1.total_cmp(&b.1));
    if check.bit_depths_m.is_empty() {
        let used = |depth: &&(usize, f64)| {
            data.readings.iter().any(|reading| (reading.setup, reading.bit_depth_m) == **depth)
        };
        let used: Vec<_> = all.iter().filter(used).copied().collect();
        let last = used.len().saturating_sub(1);
        let mut places = vec![0, last / 2, last];
        places.dedup();
        return Ok(places.into_iter().filter_map(|place| used.get(place).copied()).collect());
    }
    let mut found: Vec<(usize, f64)> = Vec::new();
    for depth_m in &check.bit_depths_m {
        let near = all.iter().filter(|place| (place.1 - depth_m).abs() <= SAME_DEPTH_M);
        let before = found.len();
        found.extend(near);
        if found.len() == before {
            let depth = |md_m: f64| Dimension::Length.format(md_m, units);
            let depths = all.iter().map(|(_, md_m)| depth(*md_m)).collect::<Vec<_>>();
            return Err(Error::BadInput(format!(
                "no reading has the bit at {}, the depth requested for the dynamic check; \
                 readings are at {}",
                depth(*depth_m),
                depths.join(", ")
            )));
        }
    }
    Ok(found)
}

/// Every reading at these depths with the result of the simulation; after a cancellation, those
/// that were finished.
pub(super) fn checked(
    (cases, check): (&[NamedCase<'_>], &CheckDynamics),
    data: &Readings,
    found: &Calibration,
    depths: &[(usize, f64)],
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Vec<DynamicCheck> {
    let used = found.points.iter().zip(&data.places);
    let all = || used.clone().chain(found.held_out.iter().zip(&data.held_out_places));
    let at = |point: &Point, place: &(usize, f64)| {
        (point.reading.setup, point.reading.bit_depth_m) == *place
    };
    let mut rows: Vec<(&Point, &String)> = Vec::new();
    for depth in depths {
        rows.extend(all().filter(|(point, _)| at(point, depth)));
    }
    let mut runs: Vec<Run> = Vec::new();
    for (point, _) in &rows {
        let run = run_of(point);
        if !runs.contains(&run) {
            runs.push(run);
        }
    }
    let answers: Vec<Mutex<Option<Result<Moved, String>>>> =
        runs.iter().map(|_| Mutex::new(None)).collect();
    let tasks: Vec<_> = runs.iter().map(|run| task(cases, data, found, run)).collect();
    let times = tasks.iter().flatten().map(|task| task.longest_s);
    let size = BatchSize { cases: runs.len(), finished: 0, simulated_s: times.sum() };
    observer.batch_started(&size);
    let order: Vec<usize> = (0..runs.len()).collect();
    let ended = Mutex::new(0);
    in_parallel(jobs(check.jobs), &order, |place| {
        if cancellation.is_cancelled() {
            return;
        }
        let watch = Watch { observer, case: place };
        let answer = match &tasks[place] {
            Ok(task) => moved(task, watch, cancellation),
            Err(reason) => Some(Err(reason.clone())),
        };
        *lock(&answers[place]) = answer;
        let mut ended = lock(&ended);
        *ended += 1;
        observer.case_ended(&CaseEnded { ended: *ended, of: runs.len(), reused_s: 0.0 });
    });
    observer.batch_ended();
    let row = |(point, place): &(&Point, &String)| {
        let run = runs.iter().position(|run| *run == run_of(point))?;
        let answer = lock(&answers[run]).clone()?;
        let channel = point.reading.channel;
        let state = &found.state;
        let beside = match channel {
            Channel::OnBottomTorque | Channel::OffBottomTorque => 0.0,
            _ => state.block_weight_N,
        };
        let in_motion = |moved: Moved| {
            let [mean, std] =
                if channel.is_torque() { moved.torque_N_m } else { moved.hook_load_N };
            InMotion {
                mean: mean + beside,
                std,
                mean_bit_depth_m: moved.mean_bit_depth_m,
                steady: moved.steady,
            }
        };
        Some(DynamicCheck {
            case: cases[data.cases[point.reading.setup]].case.name.clone(),
            place: (*place).clone(),
            reading: channel.name().to_owned(),
            is_torque: channel.is_torque(),
            bit_depth_m: point.reading.bit_depth_m,
            measured: point.reading.value,
            predicted: point.predicted,
            dynamic: answer.as_ref().ok().copied().map(in_motion),
            message: answer.err(),
        })
    };
    rows.iter().filter_map(row).collect()
}

/// Warnings: a string that had not settled, or one without a solution.
pub(super) fn warnings(checks: &[DynamicCheck]) -> Vec<String> {
    let warning = |check: &DynamicCheck| {
        let reading = check.reading.replace('_', "-");
        let at = Quantity::depth(check.bit_depth_m);
        match (&check.dynamic, &check.message) {
            (Some(dynamic), _) if dynamic.steady == Some(false) => Some(format!(
                "the dynamic simulation had not settled for {reading} with the bit at {at}, where \
                 the mean bit depth was {}: increase dynamics.settle, or reduce trip_speed",
                Quantity::depth(dynamic.mean_bit_depth_m)
            )),
            (None, Some(reason)) => Some(format!(
                "the dynamic simulation has no solution for {reading} with the bit at {at}: \
                 {reason}"
            )),
            _ => None,
        }
    };
    checks.iter().filter_map(warning).collect()
}

fn run_of(point: &Point) -> Run {
    let reading = &point.reading;
    Run { setup: reading.setup, bit_depth_m: reading.bit_depth_m, motion: reading.channel.motion() }
}

/// A simulation to set up.
struct Task {
    name: String,
    model: Model,
    operation: Operation,
    settings: DynamicsSettings,
    longest_s: f64,
}

/// The string of a row with the fitted parameters.
fn task(
    cases: &[NamedCase<'_>],
    data: &Readings,
    found: &Calibration,
    run: &Run,
) -> Result<Task, String> {
    let assembly = &data.assemblies[run.setup];
    let setup = found.state.factors.applied_to(&assembly.setup);
    let setup = setup.map_err(|error| error.to_string())?;
    let model = setup.at(run.bit_depth_m).map_err(|error| error.to_string())?;
    let operation = Operation {
        bit_torque_N_m: found.state.bit_torque_N_m,
        ..assembly.operation(run.motion, run.bit_depth_m)
    };
    // Changes of set points by the driller during a run do not apply to a reading.
    let settings = DynamicsSettings {
        schedule: Schedule::default(),
        probes: Vec::new(),
        ..cases[data.cases[run.setup]].case.dynamics.clone()
    };
    let effort = Effort::of(&model, &operation, &settings).map_err(|error| error.to_string())?;
    let name = operation.kind.name().to_owned();
    Ok(Task { name, model, operation, settings, longest_s: effort.end_s })
}

/// Loads of a simulation; `None` if it was cancelled.
fn moved(
    task: &Task,
    watch: Watch<'_>,
    cancellation: &CancellationToken,
) -> Option<Result<Moved, String>> {
    let Task { name, model, operation, settings, longest_s } = task;
    let executor = cores::alone(cancellation);
    let simulation = {
        let _shown = watch.preparing(name, "initialising the string");
        Simulation::with_executor(model, operation, settings, executor)
    };
    let mut simulation = match simulation {
        Ok(simulation) => simulation,
        Err(_) if cancellation.is_cancelled() => return None,
        Err(error) => return Some(Err(error.to_string())),
    };
    let progress = watch.simulation(name, None, [0.0, *longest_s]);
    let sample_s = simulation.sample_interval_s();
    let mut pace = Pace::new(POLL_INTERVAL_S, sample_s);
    loop {
        let (time_s, end_s) = (simulation.time_s(), simulation.end_time_s());
        progress.reach(time_s, end_s, settings.steady.is_some() && simulation.is_settling());
        if time_s >= end_s - 0.5 * sample_s {
            break;
        }
        if cancellation.is_cancelled() {
            return None;
        }
        let left = (((end_s - time_s) / sample_s).round() as u64).max(1);
        let advanced = pace.work(left, |samples| simulation.advance(samples as f64 * sample_s));
        if let Err(diverged) = advanced {
            return Some(Err(diverged.to_string()));
        }
    }
    drop(progress);
    let outcome = simulation.outcome();
    let load = |name: &str, mean: f64| {
        let statistic = outcome.statistics.iter().find(|(statistic, _)| *statistic == name);
        [mean, statistic.map_or(f64::NAN, |(_, statistic)| statistic.std)]
    };
    Some(Ok(Moved {
        hook_load_N: load("hook_load_N", outcome.scalars.hook_load_N),
        torque_N_m: load("surface_torque_N_m", outcome.scalars.surface_torque_N_m),
        mean_bit_depth_m: outcome.numerics.mean_bit_depth_m,
        steady: outcome.numerics.settled,
    }))
}
