//! The well that is measured: NP13-X1042, which is built into the program.

use std::{fs, path::PathBuf};

use serde::Serialize;
use tempfile::TempDir;
use wholestring::dynamics::{DynamicsSettings, Effort, Precision, Simulation};
use wholestring_case::{Case, Override, Template};
use wholestring_cases::NP13_X1042 as CASE;
use wholestring_results::ResultsFolder;

use super::clock::Clock;
use crate::Error;

/// Simulated time before timing begins, s, in which the transients of the initialisation decay.
const SETTLED_S: f64 = 1.0;

/// Simulated time of one timing, s: some hundredths of a second of computing.
pub(super) const TIMED_S: f64 = 1.0;

/// The case in a temporary folder.
pub(super) struct Well {
    scratch: TempDir,
    template: Template,
    changes: Vec<Override>,
}

/// The case that is measured.
#[derive(Debug, Serialize)]
pub struct MeasuredWell {
    /// Name of the case.
    pub case: String,
    /// Measured depth of the bit.
    pub bit_depth_m: f64,
    /// Elements of the string.
    pub elements: usize,
    /// Step of the dynamics.
    pub time_step_s: f64,
    /// Steps of the assembly in one of the string's, if it has steps of its own.
    pub assembly_steps: Option<u32>,
}

impl Well {
    /// The case with the user's changes.
    pub(super) fn new(changes: &[Override]) -> Result<Self, Error> {
        let scratch = tempfile::Builder::new()
            .prefix("wholestring-bench-")
            .tempdir()
            .map_err(Error::failed)?;
        let files = [(CASE.file_name, CASE.text)];
        for (name, text) in files.iter().chain(CASE.beside) {
            fs::write(scratch.path().join(name), text).map_err(Error::failed)?;
        }
        Ok(Self {
            template: Template::read(&scratch.path().join(CASE.file_name))?,
            scratch,
            changes: changes.to_vec(),
        })
    }

    /// Path of the case file.
    pub(super) fn file(&self) -> PathBuf {
        self.scratch.path().join(CASE.file_name)
    }

    /// A folder for results.
    pub(super) fn folder(&self) -> PathBuf {
        self.scratch.path().join("results")
    }

    /// The user's changes.
    pub(super) fn changes(&self) -> &[Override] {
        &self.changes
    }

    /// The case with more keys set.
    pub(super) fn case(&self, keys: &[&str]) -> Result<Case, Error> {
        let mut changes = self.changes.clone();
        for key in keys {
            changes.push(key.parse().map_err(Error::failed)?);
        }
        Ok(self.template.case(&changes)?)
    }

    pub(super) fn about(&self) -> Result<MeasuredWell, Error> {
        let case = self.case(&[])?;
        let operation = &case.operations[0];
        let effort = Effort::of(&case.model, operation, &case.dynamics);
        let effort = effort.map_err(Error::failed)?;
        Ok(MeasuredWell {
            bit_depth_m: operation.bit_depth_m,
            case: case.name,
            elements: effort.mesh.elements.len(),
            time_step_s: effort.plan.dt_s,
            assembly_steps: effort.plan.subcycling.map(|two| two.parts),
        })
    }

    /// Processor time per second of simulated time, s, with all work of `run` included. Frames are
    /// written if the case requires them.
    pub(super) fn run_s(&self, case: &Case, simulation: &Simulation) -> Result<f64, Error> {
        let mut simulation = simulation.clone();
        let folder = ResultsFolder::create(self.folder())?;
        let begin_s = simulation.time_s();
        let clock = Clock::begin();
        match case.records.frame_interval_s {
            None => simulation.advance(TIMED_S).map_err(Error::failed)?,
            Some(interval_s) => {
                let mut frames = folder.frames(&case.records.channels)?;
                let sample_s = simulation.sample_interval_s();
                let every_s = (interval_s / sample_s).round().max(1.0) * sample_s;
                while simulation.time_s() - begin_s < TIMED_S - 0.5 * every_s {
                    simulation.advance(every_s).map_err(Error::failed)?;
                    frames.push(case.operations[0].kind.name(), &simulation.frame())?;
                }
                frames.write()?;
            }
        }
        Ok(clock.elapsed_s() / (simulation.time_s() - begin_s))
    }
}

/// The string in a precision, initialised in its hole and settled, with its window started.
pub(super) fn initialise(case: &Case, precision: Precision) -> Result<Simulation, Error> {
    let settings =
        DynamicsSettings { precision, settle_s: SETTLED_S, steady: None, ..case.dynamics.clone() };
    let simulation = Simulation::new(&case.model, &case.operations[0], &settings);
    let mut simulation = simulation.map_err(Error::failed)?;
    // The window begins with the first sample after the settling.
    let beyond_s = SETTLED_S + 2.0 * simulation.sample_interval_s();
    simulation.advance(beyond_s).map_err(Error::failed)?;
    Ok(simulation)
}

/// Precisions that the case allows, and their names.
pub(super) fn precisions(case: &Case) -> Vec<(Precision, &'static str)> {
    let all = [(Precision::Double, "double"), (Precision::Single, "single")];
    let serves =
        |precision: Precision| precision.serves(&case.operations[0], &case.dynamics).is_ok();
    all.into_iter().filter(|(precision, _)| serves(*precision)).collect()
}
