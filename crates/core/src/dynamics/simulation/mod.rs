//! A run in the precision that its settings require.

mod answer;
pub mod checkpoint;
pub mod diverged;
mod initialise;
pub mod kernel_speed;
mod numbers;
pub mod observer;
mod run;
mod sampling;
pub mod settling;
mod state;
mod step;
#[cfg(feature = "rayon")]
pub mod threads;

use std::sync::Arc;

use nalgebra::Vector3;

use super::{
    assemble::SetupError,
    settings::{
        DynamicsSettings, HoistControl, Precision, SpeedController,
        schedule::{ScheduleFault, ScheduleStep},
    },
};
use crate::{
    dynamics::{
        boundary::{executor::RockExecutor, hole_friction::FrictionFault},
        output::{frame::Frame, indicators::Indicators, outcome::DynamicOutcome},
        simulation::{
            checkpoint::{Checkpoint, ResumeError},
            diverged::Diverged,
            run::Run,
        },
    },
    model::Model,
    operation::Operation,
    outcome::{EarlierRows, TimeSeries},
    rock::{Alone, Executor, bit_face::BottomHole},
    rod::{
        buckled_element::BuckledElement,
        mesh::{Mesh, MeshNode},
    },
    sizing::ElementLength,
};

/// Shortest elements that single precision serves, m. Positions are known to 2e-9 m, and the
/// resulting strain of an element of a metre is a force of a newton or two in a drill pipe, six in
/// a collar.
const SHORTEST_M: f64 = 1.0;

impl Precision {
    /// Whether this precision serves a run, or why it does not.
    ///
    /// Single precision serves strings that turn. Where a string rests, or slides without turning,
    /// friction decides node by node between rest and motion, and the answer hangs on digits that
    /// single precision does not have: a string at rest, a string about to buckle, a check of the
    /// energy. Nor does it serve elements shorter than a metre.
    ///
    /// # Errors
    /// The reason.
    pub fn serves(
        self,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<(), &'static str> {
        if self == Self::Double {
            return Ok(());
        }
        // A string that reverses its rotation is at rest in between.
        let speed = operation.rotation_rad_per_s();
        let lines = settings.schedule.steps.iter();
        let mut scheduled = lines.filter_map(|line| line.rotary_speed_rad_per_s);
        let turns = speed != 0.0 && scheduled.all(|other| speed * other > 0.0);
        if !turns {
            return Err(
                "the string does not turn all the time: which nodes of a string at rest stick, \
                 and whether it \
                 buckles, is decided in digits that single precision does not have",
            );
        }
        let refinement = f64::from(settings.mesh.refinement);
        if matches!(settings.mesh.element_length, ElementLength::Uniform(m) if m / refinement < SHORTEST_M)
        {
            return Err(
                "the elements are shorter than 1 m (3.3 ft): the last digit of a position strains them by \
                 newtons",
            );
        }
        Ok(())
    }
}

/// A drill string in time.
#[derive(Debug, Clone)]
pub struct Simulation(Either);

#[derive(Debug, Clone)]
enum Either {
    Double(Box<Run<f64>>),
    Single(Box<Run<f32>>),
}

/// The same of either.
macro_rules! either {
    ($simulation:expr, $run:ident => $what:expr) => {
        match $simulation {
            Either::Double($run) => $what,
            Either::Single($run) => $what,
        }
    };
}

use either;

impl Simulation {
    /// Initialises the string in its hole, ready to run.
    ///
    /// The bit is placed so that it passes the operation's depth in the middle of the window: a
    /// string that trips at 0.3 m/s for a minute is then, on average, where a static calculation
    /// has it.
    ///
    /// # Errors
    /// A setting out of range, a precision that does not serve, or a soft string without solution.
    pub fn new(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<Self, SetupError> {
        Self::with_executor(model, operation, settings, Arc::new(Alone))
    }

    /// The same with an executor for the solid rock under the bit from the first: the bit is run
    /// in before the string is initialised. The answer does not depend on it.
    ///
    /// # Errors
    /// Those of [`Simulation::new`].
    pub fn with_executor(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        executor: Arc<dyn Executor + Send + Sync>,
    ) -> Result<Self, SetupError> {
        let executor = RockExecutor::of(executor);
        Ok(Self(match settings.precision {
            Precision::Double => {
                Either::Double(Box::new(Run::new(model, operation, settings, executor)?))
            }
            Precision::Single => {
                Either::Single(Box::new(Run::new(model, operation, settings, executor)?))
            }
        }))
    }

    /// Resumes a run where [`Simulation::checkpoint`] left it. Model, operation and settings are
    /// those that it began with: others would continue, but with an answer to neither case.
    ///
    /// # Errors
    /// A checkpoint of another string, or a run that could not have begun.
    pub fn resume(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        checkpoint: Checkpoint<'_>,
    ) -> Result<Self, ResumeError> {
        Ok(Self(match settings.precision {
            Precision::Double => {
                Either::Double(Box::new(Run::resume(model, operation, settings, checkpoint)?))
            }
            Precision::Single => {
                Either::Single(Box::new(Run::resume(model, operation, settings, checkpoint)?))
            }
        }))
    }

    /// Sets the executor of the solid rock under the bit; the answer does not depend on it. A simulation
    /// that was resumed has to be set anew.
    pub fn set_executor(&mut self, executor: Arc<dyn Executor + Send + Sync>) {
        either!(&mut self.0, run => run.set_executor(executor));
    }

    /// Gives every node an additional velocity, m/s, and an additional spin, rad/s: a blow.
    /// `impulse` is called for each node but the top, which is clamped.
    pub fn apply_impulse(&mut self, impulse: impl Fn(&MeshNode) -> (Vector3<f64>, f64)) {
        either!(&mut self.0, run => run.apply_impulse(impulse));
    }

    /// Advances by `seconds`, to the nearest sample. The remainder is carried over to the next
    /// call, so that many short calls take as long as their sum. On solid rock, where one may take
    /// a long time, it ends between two steps if the [executor](Self::set_executor) requests a
    /// stop; the next call continues with that sample, to the same bits.
    ///
    /// # Errors
    /// A run that diverged; its earlier samples remain available.
    pub fn advance(&mut self, seconds: f64) -> Result<(), Diverged> {
        either!(&mut self.0, run => run.advance(seconds))
    }

    /// Adds a line to the schedule: set points that go to new values, at once or in a ramp. Its
    /// time is that of the run; a time in the past counts as now. It replaces a line that is still
    /// ramping the same set point. Checkpoints contain it.
    ///
    /// # Errors
    /// A time or a set point that is not finite, or a time that is negative.
    pub fn add_to_schedule(&mut self, mut line: ScheduleStep) -> Result<(), ScheduleFault> {
        // Not the larger of both, which of NaN and a number is the number.
        if line.at_s < self.time_s() {
            line.at_s = self.time_s();
        }
        either!(&mut self.0, run => run.state.set_points.add(line))
    }

    /// The element that a weight on bit, N, would load most beyond its own buckling load, by the soft
    /// string as the string turns or slides now: a weight that the mesh was not chosen for. None
    /// where all elements are short enough.
    pub fn buckled_element_under(&self, weight_on_bit_N: f64) -> Option<BuckledElement> {
        either!(&self.0, run => run.buckled_element_under(weight_on_bit_N))
    }

    /// Sets the kinetic coefficient of friction of each section of the hole from now on: cuttings
    /// that gather, a mud that lubricates. The change is linear in time over `ramp_s`, updated
    /// every 16 steps of the run; the coefficients of static and rotational friction keep their
    /// ratios to it. Checkpoints contain it. A [`FrictionCoefficient`](super::FrictionCoefficient)
    /// receives it as the section's coefficient.
    ///
    /// # Errors
    /// Another count than the hole has sections, a coefficient that is negative or not finite, or
    /// such a time.
    pub fn set_friction(&mut self, kinetic: &[f64], ramp_s: f64) -> Result<(), FrictionFault> {
        either!(&mut self.0, run => run.set_friction(kinetic, ramp_s))
    }

    /// Begins the window anew and discards the earlier samples, so that a run of hours takes no
    /// more memory than one of minutes: the next sample is the window's first, and the first of
    /// [`series`](Self::series). The motion is unaffected. Called between two calls of
    /// [`Simulation::advance`].
    pub fn restart_window(&mut self) {
        either!(&mut self.0, run => run.restart_window());
    }

    /// Drops the samples of before a time, s: from [`series`](Self::series), from the map of
    /// contact and from the probes. The last sample stays, and, while the string settles, those
    /// needed for the test of steadiness. Statistics of scalars are then those of the samples that
    /// are left; profiles along the string and the energy remain those of the whole window. The
    /// motion is unaffected.
    pub fn forget(&mut self, before_s: f64) {
        either!(&mut self.0, run => run.forget(before_s));
    }

    /// Hands over the first rows of [`series`](Self::series), so that a run of hours takes no more
    /// memory than one of minutes: the caller has kept them, and
    /// [`outcome_with`](Self::outcome_with) reads them from there. No more than the [spare
    /// rows](Self::spare_rows) go; the records of probes stay. The motion is unaffected.
    pub fn hand_over(&mut self, rows: usize) {
        either!(&mut self.0, run => run.hand_over(rows));
    }

    /// The [answer](Self::outcome) so far of a run whose first rows were [handed
    /// over](Self::hand_over), to the same bits as if they were in memory; the series of the answer
    /// are the rows that are.
    pub fn outcome_with(&self, earlier: &dyn EarlierRows) -> DynamicOutcome {
        either!(&self.0, run => run.outcome_with(earlier))
    }

    /// Gives the top drive another controller from now on; its torque is continuous. Checkpoints
    /// contain it. Returns false where the drive has no built-in controller: where it follows its
    /// set point at any torque, or under a user-defined controller.
    pub fn set_speed_controller(&mut self, controller: SpeedController) -> bool {
        either!(&mut self.0, run => run.set_speed_controller(controller))
    }

    /// Changes the hoist from now on: a connection, a stop, a lift.
    pub fn set_hoist(&mut self, control: HoistControl) {
        either!(&mut self.0, run => run.set_hoist(control));
    }

    /// Sets the flow rate of the pumps from now on, m³/s; the pressure drop of the bit and the
    /// speed of a mud motor follow. Without a rheology the mud's flow has no effect on the string.
    pub fn set_flow_rate(&mut self, flow_m3_per_s: f64) {
        either!(&mut self.0, run => run.set_flow_rate(flow_m3_per_s));
    }
}

/// Accessors of a run of either precision.
macro_rules! accessors {
    ($($(#[$meaning:meta])* $name:ident: $of:ty,)+) => {
        impl Simulation {
            $(
                $(#[$meaning])*
                pub fn $name(&self) -> $of {
                    either!(&self.0, run => run.$name())
                }
            )+
        }
    };
}

accessors! {
    /// The present state of the run, to be written to a checkpoint: between two calls of
    /// [`Simulation::advance`], at any time.
    checkpoint: Checkpoint<'_>,
    /// The answer so far: over the window if it has begun, over everything sampled otherwise.
    outcome: DynamicOutcome,
    /// Indicators of [`outcome`](Self::outcome), without the rest of it: the percentiles take most
    /// of the time there.
    indicators: Indicators,
    /// The samples so far, from time zero or where the window was
    /// [restarted](Self::restart_window): the last row is that of the last sample.
    series: &TimeSeries,
    /// Rows of [`series`](Self::series) that can be [handed over](Self::hand_over): all but the
    /// last, and while the string settles those needed for the test of steadiness.
    spare_rows: usize,
    /// Rows that were handed over.
    handed_over: usize,
    /// Mean weight on bit of [`outcome`](Self::outcome), N, without the rest of it.
    mean_weight_on_bit_N: f64,
    /// The whole string as it is now: after [`advance`](Self::advance), at the end of a sample.
    frame: Frame,
    /// The lines of the schedule, those that were added too: the line that began last is the
    /// series' [`schedule_line`](TimeSeries::schedule_line), counted from one.
    schedule: &[ScheduleStep],
    /// The kinetic coefficient of friction of each section of the hole now.
    friction: Vec<f64>,
    /// Time since the start, s.
    time_s: f64,
    /// Time at which the window ends, s; at the latest, as long as the run settles until it is
    /// steady: the time is known when the window begins.
    end_time_s: f64,
    /// Whether the bit drills solid rock.
    is_on_rock: bool,
    /// Whether the window is yet to begin.
    is_settling: bool,
    /// Whether the last step required more torque than the top drive can supply.
    is_top_drive_stalled: bool,
    /// Step, s.
    time_step_s: f64,
    /// Time between two samples, s: the setting, which the time step divides.
    sample_interval_s: f64,
    /// Whole samples since the start.
    samples: u64,
    /// Number of elements.
    elements: usize,
    /// Elements times the steps that each takes for a simulated second.
    element_steps_per_s: f64,
    /// The element that buckled most beyond its own load between its nodes, at any time since the
    /// start: from then on the string folds there as no pipe does. None while the elements are short
    /// enough for the compression on them.
    buckled_element: Option<BuckledElement>,
    /// The nodes and elements of the string.
    mesh: &Mesh,
    /// Kinetic, elastic and potential energy of the string, J: second-order accurate in the step.
    energy_J: f64,
    /// Kinetic energy of the string, J.
    kinetic_energy_J: f64,
    /// The pattern that the bit has left on the bottom of the hole, radii from the bit's axis,
    /// angles from the high side to the right, depths below the bit's nose; none without solid
    /// rock.
    bottom_hole: Option<BottomHole>,
    /// Whether the processor adds to a product before it is rounded (fused multiply-add): in single
    /// precision alone, where it can. It changes the last digit of a run.
    is_fused: bool,
}
