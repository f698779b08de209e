//! Events, solved.

use std::ops::ControlFlow;

use wholestring::{
    dynamics::{Diverged, DynamicsSettings, SetupError, Simulation},
    mud::Hydraulics,
    operation::Operation,
    outcome::Solution,
    string::AssemblyError,
};

use wholestring_judge::Check;

use super::{
    DynamicPlan, Event, History, Peak, extremes::Extremes, peak::Toward, settings::REST_S,
};
use crate::{
    Broomstick, FrictionLevel,
    hydraulics::{GelBreak, gel_break},
};

/// An event with the bit at a depth and a friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EventTask {
    /// What happens.
    pub event: Event,
    /// How much friction there is.
    pub friction: FrictionLevel,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
}

/// What came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct EventAnswer {
    /// Hook load without block, N.
    pub hook_load_N: Peak,
    /// Surface torque, N·m, of a string that comes to turn.
    pub surface_torque_N_m: Option<Peak>,
    /// Pressure of the pump, Pa, where it starts.
    pub pump_pressure_Pa: Option<Peak>,
    /// What breaks the gel, where the pump starts and the mud's gel strength is known.
    pub gel: Option<GelBreak>,
    /// The event at surface.
    pub history: History,
    /// How near its peak is to what pipe and rig bear.
    pub limits: Vec<Check>,
}

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoDynamics {
    /// The string cannot be as long as the bit is deep.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// The run cannot begin.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// It diverged.
    #[error(transparent)]
    Diverged(#[from] Diverged),
    /// The plan has no set points, or a series no samples.
    #[error("there is nothing to look at")]
    Nothing,
}

impl DynamicPlan {
    /// What is to be looked at, event after event, friction after friction, down the hole.
    pub fn tasks(&self) -> Vec<EventTask> {
        let mut tasks = Vec::new();
        for &event in &self.events {
            for &friction in &self.frictions {
                let task = |&bit_depth_m: &f64| EventTask { event, friction, bit_depth_m };
                tasks.extend(self.bit_depths_m.iter().map(task));
            }
        }
        tasks
    }
}

impl Broomstick {
    /// An event; none where `goes_on` said no on the way.
    ///
    /// # Errors
    /// Why it has no answer.
    pub fn solve_event(
        &self,
        task: &EventTask,
        plan: &DynamicPlan,
        dynamics: &DynamicsSettings,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<EventAnswer>, NoDynamics> {
        let EventTask { event, friction, bit_depth_m } = *task;
        let operation = plan.operation(event, bit_depth_m).ok_or(NoDynamics::Nothing)?;
        let model = self.setup(friction).at(bit_depth_m)?;
        let settings = plan.run(event, &operation, dynamics);
        let mut simulation = Simulation::new(&model, &operation, &settings)?;
        let mut extremes = Extremes::default();
        let outcome = simulation.to_end_with(&mut |now: &Simulation| {
            if now.time_s() > REST_S {
                extremes.see(&now.frame());
            }
            if goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })?;
        if !goes_on() {
            return Ok(None);
        }
        let history = History::of(&outcome.series);
        let peak = |values: &[f64], toward| Peak::of(&history.time_s, values, plan.watch_s, toward);
        let toward = match event {
            Event::PickUpFromSlips => Toward::More,
            Event::SlackOffFromSlips => Toward::Less,
            Event::BreakCirculation | Event::BreakRotation => Toward::Steady,
        };
        let hook_load_N = peak(&history.hook_load_N, toward).ok_or(NoDynamics::Nothing)?;
        let surface_torque_N_m =
            peak(&history.surface_torque_N_m, Toward::More).filter(|_| event.turns());
        let pressures: Option<Vec<f64>> = history.pump_pressure_Pa.iter().copied().collect();
        let pump_pressure_Pa =
            pressures.and_then(|of| peak(&of, Toward::More)).filter(|_| event.circulates());
        let gel = plan.gel_strength_Pa.filter(|_| event.circulates());
        let gel = gel.map(|strength_Pa| gel_break(&model, bit_depth_m, strength_Pa));
        let pump_Pa = pump_pressure_Pa.map_or(0.0, |of| of.peak);
        let pump_Pa = gel.map_or(pump_Pa, |of| of.pressure_Pa().max(pump_Pa));
        let profile = extremes.in_profile(&outcome.nodes);
        let hydraulics =
            outcome.hydraulics.map(|of| Hydraulics { pump_pressure_Pa: pump_Pa, ..of });
        let solution = Solution { profile: &profile, hydraulics, ..(&outcome).into() };
        let found = self.judge().limits(&model, &steady(event, &operation), &solution);
        let is_its = |check: &Check| event.bears_on(check.kind);
        Ok(Some(EventAnswer {
            hook_load_N,
            surface_torque_N_m,
            pump_pressure_Pa,
            gel,
            history,
            limits: found.checks.into_iter().filter(is_its).collect(),
        }))
    }
}

/// The operation as limits see it: a string that breaks circulation does not turn.
fn steady(event: Event, operation: &Operation) -> Operation {
    let speed = if event.turns() { operation.rotary_speed_rad_per_s } else { 0.0 };
    Operation { rotary_speed_rad_per_s: speed, ..*operation }
}
