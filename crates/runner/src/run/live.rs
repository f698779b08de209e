//! A dynamic run that a front end advances step by step and whose set points it changes, for a
//! controller, a digital twin or a learning environment.

use std::{num::NonZeroUsize, sync::Arc, time::Duration};

use serde::{Deserialize, Serialize};
use wholestring::{
    dynamics::{Checkpoint, HoistSetPoint, ScheduleStep, SetupError, Simulation, SpeedController},
    operation::Operation,
    outcome::Solution,
    rod::buckled_element::BuckledElement,
};
use wholestring_case::{Case, MAX_FRICTION, refused_set_point};
use wholestring_judge::shorter_element;
use wholestring_results::{Status, checkpoint_bytes, digest, read_checkpoint_bytes};
use wholestring_units::{Dimension, UnitSet};

use super::{
    answers::Answers,
    own_laws::{OwnLaws, StoredLaws},
    solve::no_answer,
};
use crate::{
    cancellation::CancellationToken,
    clock::Instant,
    cores::RockThreads,
    error::Error,
    observer::{Observer, Watch},
    pace::Pace,
    record::{
        Record,
        rows::{CarriedOut, Effort},
    },
};

/// Longest simulated time between two checks for cancellation, s; a slow run checks by wall-clock
/// time.
const POLL_INTERVAL_S: f64 = 0.05;

/// A dynamic run that a front end advances.
pub struct Live {
    case: Arc<Case>,
    operation: Operation,
    simulation: Simulation,
    rock_threads: RockThreads,
    took: Duration,
    /// Sum of the times that it was advanced by, s; the run is at the nearest sample.
    target_s: f64,
    laws: StoredLaws,
    /// Cancelled by a user's law that returned no answer.
    failed: CancellationToken,
}

/// Contents of a checkpoint of it.
#[derive(Serialize, Deserialize)]
struct Stored<'a> {
    identity: String,
    operation: String,
    took_s: f64,
    target_s: f64,
    laws: StoredLaws,
    simulation: Checkpoint<'a>,
}

impl Live {
    /// Initialises the string for an operation of the case, ready to run; `None` selects its only
    /// one. Laws of the user replace those of the case. `jobs` are the threads that work on solid
    /// rock under the bit; one per core by default.
    ///
    /// # Errors
    /// An operation that is not in the case, a hoist whose lift is found by runs of the whole case,
    /// laws where none apply, a string without a solution, or a cancellation.
    pub fn begin(
        case: Arc<Case>,
        operation: Option<&str>,
        laws: &OwnLaws,
        jobs: Option<NonZeroUsize>,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<Self, Error> {
        let mut operation = *named(&case, operation)?;
        if case.tunes_hook_load {
            let message = "the lift of this case's hoist is found by runs of the whole case: use \
                           another hoist for a live run, such as the autodriller";
            return Err(Error::BadInput(message.to_owned()));
        }
        let start = Instant::now();
        let watch = Watch { observer, case: 0 };
        let what = "initialising the string";
        let preparation = watch.preparing(operation.kind.name(), what);
        let rock_threads = RockThreads::of_others(&case, jobs);
        let executor = rock_threads.executor(cancellation);
        let (mut settings, failed) = (case.dynamics.clone(), CancellationToken::new());
        let stored = laws.begin(&operation, &settings)?;
        laws.apply(&stored, &mut operation, &mut settings, &failed)?;
        let begun = Simulation::with_executor(&case.model, &operation, &settings, executor);
        let simulation = begun.map_err(|error| match error {
            SetupError::Stopped => Error::Interrupted,
            error => Error::Failed(no_answer("dynamic model", &error)),
        })?;
        drop(preparation);
        let took = start.elapsed();
        let target_s = simulation.time_s();
        let laws = stored;
        Ok(Self { case, operation, simulation, rock_threads, took, target_s, laws, failed })
    }

    /// Continues from the bytes of [`Live::checkpoint`], with bitwise equal results.
    ///
    /// # Errors
    /// Bytes that are damaged, of another version of the program, of another case, or with other
    /// laws of the user; laws are identified by their names and rates.
    pub fn resume(
        case: Arc<Case>,
        laws: &OwnLaws,
        jobs: Option<NonZeroUsize>,
        bytes: &[u8],
    ) -> Result<Self, Error> {
        let stored: Stored<'static> = read_checkpoint_bytes(bytes)?;
        let anew = |reason: String| Error::NotResumable { noun: "simulation", reason };
        if stored.identity != digest(&case.identity()) {
            return Err(anew("the checkpoint is of another case".to_owned()));
        }
        if !stored.laws.is_of(laws) {
            let (found, own) = (stored.laws.titles(), laws.titles());
            return Err(anew(format!("the checkpoint is of a run with {found}, not with {own}")));
        }
        let took = Duration::try_from_secs_f64(stored.took_s);
        let took = took.map_err(|_| anew("the checkpoint is damaged: its time".to_owned()))?;
        let mut operation = *named(&case, Some(&stored.operation))?;
        let (mut settings, failed) = (case.dynamics.clone(), CancellationToken::new());
        laws.apply(&stored.laws, &mut operation, &mut settings, &failed)?;
        let resumed = Simulation::resume(&case.model, &operation, &settings, stored.simulation);
        let simulation = resumed.map_err(|error| anew(error.to_string()))?;
        let rock_threads = RockThreads::of_others(&case, jobs);
        let (target_s, laws) = (stored.target_s, stored.laws);
        if !target_s.is_finite() {
            return Err(anew("the checkpoint is damaged: its target time".to_owned()));
        }
        Ok(Self { case, operation, simulation, rock_threads, took, target_s, laws, failed })
    }

    /// Advances by `seconds`, to the nearest sample; a cancellation stops it earlier. Times add up
    /// exactly: the remainder of a sample carries over to the next call, so that many short calls
    /// reach the same time as one long call. After a stop the time counts from the current time of
    /// the run.
    ///
    /// # Errors
    /// A cancellation, a law of the user that returned no answer, a run that diverged, or elements
    /// that are too long for their compression; earlier samples remain available. The run is then
    /// at a sample, on solid rock possibly between two, and can continue unless it diverged. After
    /// a law returned no answer, its previous answer was held until that sample.
    pub fn advance(
        &mut self,
        seconds: f64,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<(), Error> {
        if !(seconds.is_finite() && seconds >= 0.0) {
            let message =
                format!("a simulation cannot advance by {seconds} s: expected zero or more");
            return Err(Error::BadInput(message));
        }
        self.check_elements()?;
        let start = Instant::now();
        let sample_s = self.simulation.sample_interval_s();
        let from_s = self.simulation.time_s();
        let end_s = self.target_s + seconds;
        let watch = Watch { observer, case: 0 };
        let report = watch.simulation(self.operation.kind.name(), None, [from_s, end_s]);
        let target = (end_s / sample_s).round() as u64;
        let mut missing = target.saturating_sub(self.simulation.samples());
        let asks = self.laws != StoredLaws::default();
        // A run with laws of the user stops at the sample at which one returned no answer.
        let mut pace = Pace::new(if asks { 0.0 } else { POLL_INTERVAL_S }, sample_s);
        self.failed.reset();
        self.simulation.set_executor(self.rock_threads.executor(cancellation));
        let mut done = Ok(());
        while missing > 0 && done.is_ok() {
            if cancellation.is_cancelled() {
                done = Err(Error::Interrupted);
                break;
            }
            let (next, advanced) =
                pace.work(missing, |next| (next, self.simulation.advance(next as f64 * sample_s)));
            done = advanced.map_err(|diverged| Error::Failed(diverged.to_string()));
            missing -= next;
            if done.is_ok() {
                done = self.check_elements();
            }
            if done.is_ok() && self.failed.is_cancelled() {
                let message = format!("no answer of {}", self.laws.titles());
                done = Err(Error::Failed(message));
            }
            report.reach(self.simulation.time_s(), end_s, false);
        }
        self.took += start.elapsed();
        self.target_s = if done.is_ok() { end_s } else { self.simulation.time_s() };
        done
    }

    /// Adds a line to the schedule: set points that change to new values. A time in the past is
    /// replaced by the current time.
    ///
    /// # Errors
    /// A time or a set point that a case could not have, or a weight on bit for which the elements
    /// are too long.
    pub fn add_to_schedule(&mut self, line: ScheduleStep) -> Result<(), Error> {
        if let Some(refusal) = refused_set_point(&line) {
            return Err(Error::BadInput(refusal));
        }
        if let Some(HoistSetPoint::WeightOnBit(weight_N)) = line.hoist
            && weight_N > self.set_weight_N()
            && let Some(element) = self.simulation.buckled_element_under(weight_N)
        {
            return Err(Error::BadInput(refused(weight_N, &element, self.case.units)));
        }
        self.simulation.add_to_schedule(line).map_err(|fault| Error::BadInput(fault.to_string()))
    }

    /// Weight on bit that the autodriller holds, N; without an autodriller, that of the operation.
    fn set_weight_N(&self) -> f64 {
        let set_N = self.simulation.series().weight_on_bit_set_N.last().copied().flatten();
        set_N.unwrap_or(self.operation.weight_on_bit_N)
    }

    /// Returns an error if an element has buckled between its nodes, because from then on the
    /// string folds.
    fn check_elements(&self) -> Result<(), Error> {
        match self.simulation.buckled_element() {
            Some(element) => Err(Error::Failed(stopped(&element, self.case.units))),
            None => Ok(()),
        }
    }

    /// Sets the kinetic coefficient of friction: one for the whole hole, or one for each of its
    /// sections from the surface down, reached linearly in time within `ramp_s`.
    ///
    /// # Errors
    /// Another number of coefficients, a coefficient that a case cannot have, or an invalid time.
    pub fn set_friction(&mut self, kinetic: &[f64], ramp_s: f64) -> Result<(), Error> {
        if let Some(coefficient) =
            kinetic.iter().find(|kinetic| !(0.0..=MAX_FRICTION).contains(*kinetic))
        {
            let message =
                format!("a coefficient of friction of {coefficient}: expected 0 to {MAX_FRICTION}");
            return Err(Error::BadInput(message));
        }
        let sections = self.case.model.well.hole.sections().len();
        let changed = match kinetic {
            [one] => self.simulation.set_friction(&vec![*one; sections], ramp_s),
            several => self.simulation.set_friction(several, ramp_s),
        };
        changed.map_err(Error::bad_input)
    }

    /// Sets another controller of the top drive; its torque continues from the current value.
    ///
    /// # Errors
    /// A drive that follows its set point at any torque, because it has no controller.
    pub fn set_speed_controller(&mut self, controller: SpeedController) -> Result<(), Error> {
        if self.simulation.set_speed_controller(controller) {
            return Ok(());
        }
        let message = "the top drive follows its set point whatever torque that takes: it has no \
                       controller unless [top_drive] names one";
        Err(Error::BadInput(message.to_owned()))
    }

    /// Restarts the window and drops earlier samples, so that memory does not grow with the
    /// duration of a run.
    pub fn restart_window(&mut self) {
        self.simulation.restart_window();
    }

    /// Drops the samples before a time, s: see [`Simulation::forget`].
    pub fn forget(&mut self, before_s: f64) {
        self.simulation.forget(before_s);
    }

    /// Whether the bit drills solid rock, so that a sample takes long.
    pub fn is_on_rock(&self) -> bool {
        self.simulation.is_on_rock()
    }

    /// The simulation in its current state.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// The operation.
    pub fn operation(&self) -> &Operation {
        &self.operation
    }

    /// Returns the whole state as bytes, from which [`Live::resume`] continues.
    ///
    /// # Errors
    /// None in a valid run.
    pub fn checkpoint(&self) -> Result<Vec<u8>, Error> {
        let stored = Stored {
            identity: digest(&self.case.identity()),
            operation: self.operation.kind.name().to_owned(),
            took_s: self.took.as_secs_f64(),
            target_s: self.target_s,
            laws: self.laws.clone(),
            simulation: self.simulation.checkpoint(),
        };
        Ok(checkpoint_bytes(&stored)?)
    }

    /// Results so far, as for a run interrupted now: over the window if it has begun, otherwise
    /// over all samples.
    pub fn answers(&self) -> Answers {
        let mut record = Record::in_memory(&self.case, self.case.units);
        record.schedule_is(self.simulation.schedule());
        record.friction_is(&self.simulation.friction());
        let outcome = self.simulation.outcome();
        let bottom = self.simulation.bottom_hole();
        let carried_out = CarriedOut {
            status: Status::Interrupted,
            lift: None,
            bottom: bottom.as_ref(),
            effort: Effort { took: self.took, runs: 1 },
        };
        record.add(&self.operation, &Solution::from(&outcome), carried_out);
        Answers::of(&self.case, record)
    }
}

/// The operation of that name, or the only one.
fn named<'a>(case: &'a Case, name: Option<&str>) -> Result<&'a Operation, Error> {
    let there = || {
        let names: Vec<&str> =
            case.operations.iter().map(|operation| operation.kind.name()).collect();
        names.join(", ")
    };
    match (name, &case.operations[..]) {
        (None, [only]) => Ok(only),
        (None, _) => {
            let message = format!("the case has several operations: name one of {}", there());
            Err(Error::BadInput(message))
        }
        (Some(name), all) => {
            all.iter().find(|operation| operation.kind.name() == name).ok_or_else(|| {
                Error::BadInput(format!("the case has no operation `{name}`: it has {}", there()))
            })
        }
    }
}

// Sentences about elements that are too long for their compression.

/// Reason why a live run stops.
pub(super) fn stopped(element: &BuckledElement, units: UnitSet) -> String {
    format!(
        "{} buckles between its nodes under a compression of {}, its own buckling load is {}: the \
         string folds there, which a real pipe does not. {}",
        element_in_words(element, units),
        force(element.compression_N, units),
        force(element.own_load_N, units),
        remedy(element, units),
    )
}

/// Reason why a weight on bit, N, is refused.
pub(super) fn refused(weight_N: f64, element: &BuckledElement, units: UnitSet) -> String {
    format!(
        "a weight on bit of {} exceeds what the mesh is made for: {} would buckle between its nodes \
         under a compression of {}, its own buckling load is {}. {}",
        force(weight_N, units),
        element_in_words(element, units),
        force(element.compression_N, units),
        force(element.own_load_N, units),
        remedy(element, units),
    )
}

fn element_in_words(element: &BuckledElement, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    format!(
        "the element of {:.1} {unit} at {:.0} {unit}",
        unit.from_si(element.length_m),
        unit.from_si(element.md_m),
        unit = unit.symbol,
    )
}

fn remedy(element: &BuckledElement, units: UnitSet) -> String {
    format!(
        "Begin the simulation again with this weight in the operation or the schedule of the case, \
         which the automatic mesh is chosen for, or with mesh.element_length = {:?}",
        shorter_element(element, units)
    )
}

/// A force in four digits for a sentence.
fn force(force_N: f64, units: UnitSet) -> String {
    let unit = Dimension::Force.unit_in(units);
    let force = unit.from_si(force_N);
    let scale = libm::pow(10.0_f64, 3.0 - libm::log10(force.abs()).floor());
    let rounded = if scale.is_finite() { (force * scale).round() / scale } else { force };
    format!("{rounded} {}", unit.symbol)
}
