//! The well that is measured: NP13-X1042, which the program brings along.

use std::{fs, path::PathBuf};

use serde::Serialize;
use wholestring::dynamics::{DynamicsSettings, Effort, Precision, Simulation};
use wholestring_case::{Case, Override, Template};
use wholestring_results::ResultsFolder;

use super::{clock, clock::Clock, scratch::Scratch};
use crate::{
    color::color,
    failure::{Failure, failed},
};

const CASE: (&str, &str) = ("np13-x1042.toml", include_str!("../../../../cases/np13-x1042.toml"));
const SURVEY: (&str, &str) =
    ("np13-x1042-survey.csv", include_str!("../../../../cases/np13-x1042-survey.csv"));

/// Simulated time before anything is timed, s: what the initialisation has left is gone.
const SETTLED_S: f64 = 1.0;

/// Simulated time that is timed at once, s: some hundredths of a second of computing.
pub(crate) const TIMED_S: f64 = 1.0;

/// The case, in a folder of its own.
pub(crate) struct Well {
    scratch: Scratch,
    template: Template,
    changes: Vec<Override>,
}

/// What is measured.
#[derive(Serialize)]
pub(crate) struct About {
    case: String,
    bit_depth_m: f64,
    elements: usize,
    time_step_s: f64,
}

impl Well {
    /// The case with the user's changes.
    pub(crate) fn new(changes: &[Override]) -> Result<Self, Failure> {
        let scratch = Scratch::new().map_err(|error| failed(&error))?;
        for (name, text) in [CASE, SURVEY] {
            fs::write(scratch.path().join(name), text).map_err(|error| failed(&error))?;
        }
        let template = Template::read(&scratch.path().join(CASE.0));
        Ok(Self {
            template: template.map_err(|report| Failure::Failed(report.render(color())))?,
            scratch,
            changes: changes.to_vec(),
        })
    }

    /// Where the case lies.
    pub(crate) fn file(&self) -> PathBuf {
        self.scratch.path().join(CASE.0)
    }

    /// A folder in which results may be written.
    pub(crate) fn folder(&self) -> PathBuf {
        self.scratch.path().join("results")
    }

    /// The user's changes.
    pub(crate) fn changes(&self) -> &[Override] {
        &self.changes
    }

    /// The case with more keys set.
    pub(crate) fn case(&self, keys: &[&str]) -> Result<Case, Failure> {
        let mut changes = self.changes.clone();
        for key in keys {
            changes.push(key.parse().map_err(|error| failed(&error))?);
        }
        self.template.case(&changes).map_err(|report| Failure::BadInput(report.render(color())))
    }

    pub(crate) fn about(&self) -> Result<About, Failure> {
        let case = self.case(&[])?;
        let operation = &case.operations[0];
        let effort = Effort::of(&case.model, operation, &case.dynamics);
        let effort = effort.map_err(|error| failed(&error))?;
        Ok(About {
            bit_depth_m: operation.bit_depth_m,
            case: case.name,
            elements: effort.mesh.elements.len(),
            time_step_s: effort.plan.dt_s,
        })
    }

    /// Processor time that a second of simulated time takes, s, with everything that `run` does in
    /// it. Where the case requires frames, they are written.
    pub(crate) fn run_s(&self, case: &Case, simulation: &Simulation) -> Result<f64, Failure> {
        let mut simulation = simulation.clone();
        let folder = ResultsFolder::create(self.folder())?;
        let begin_s = simulation.time_s();
        let clock = Clock::begin();
        match case.records.frame_interval_s {
            None => simulation.advance(TIMED_S).map_err(|error| failed(&error))?,
            Some(interval_s) => {
                let mut frames = folder.frames(&case.records.channels)?;
                let sample_s = simulation.sample_interval_s();
                let every_s = (interval_s / sample_s).round().max(1.0) * sample_s;
                while simulation.time_s() - begin_s < TIMED_S - 0.5 * every_s {
                    simulation.advance(every_s).map_err(|error| failed(&error))?;
                    frames.push(case.operations[0].kind.name(), &simulation.frame())?;
                }
                frames.write()?;
            }
        }
        Ok(clock.elapsed_s() / (simulation.time_s() - begin_s))
    }
}

impl About {
    pub(crate) fn sentence(&self, count: usize) -> String {
        let Self { case, bit_depth_m, elements, time_step_s } = self;
        let (kind, step_ms) = (clock::KIND, 1e3 * time_step_s);
        format!(
            "{case}: bit at {bit_depth_m:.0} m, {elements} elements, steps of {step_ms:.3} ms; \
             contact, friction and statistics on\n\
             {kind}, median of {count}\n"
        )
    }
}

/// The string in a precision, initialised in its hole and settled, its window begun.
pub(crate) fn initialise(case: &Case, precision: Precision) -> Result<Simulation, Failure> {
    let settings =
        DynamicsSettings { precision, settle_s: SETTLED_S, steady: None, ..case.dynamics.clone() };
    let simulation = Simulation::new(&case.model, &case.operations[0], &settings);
    let mut simulation = simulation.map_err(|error| failed(&error))?;
    // The window begins with the first sample after the settling.
    let beyond_s = SETTLED_S + 2.0 * simulation.sample_interval_s();
    simulation.advance(beyond_s).map_err(|error| failed(&error))?;
    Ok(simulation)
}

/// The precisions that serve the case, and how they are called.
pub(crate) fn precisions(case: &Case) -> Vec<(Precision, &'static str)> {
    let all = [(Precision::Double, "double"), (Precision::Single, "single")];
    let serves =
        |precision: Precision| precision.serves(&case.operations[0], &case.dynamics).is_ok();
    all.into_iter().filter(|(precision, _)| serves(*precision)).collect()
}
