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
    DynamicPlan, Event, History, Peak,
    peak::{Extremes, Toward, bears_on},
    settings::REST_S,
};
use crate::{
    Broomstick, FrictionLevel,
    hydraulics::{GelBreak, gel_break},
};

/// An event with the bit at a depth and a friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EventTask {
    /// The event.
    pub event: Event,
    /// Friction level.
    pub friction: FrictionLevel,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
}

/// Result of an event.
#[derive(Debug, Clone, PartialEq)]
pub struct EventAnswer {
    /// Hook load without block, N.
    pub hook_load_N: Peak,
    /// Surface torque, N·m, of a string that starts to rotate.
    pub surface_torque_N_m: Option<Peak>,
    /// Pressure of the pump, Pa, where it starts.
    pub pump_pressure_Pa: Option<Peak>,
    /// Gel breaking pressures, where the pump starts and the mud's gel strength is known.
    pub gel: Option<GelBreak>,
    /// The event at surface.
    pub history: History,
    /// The limits of pipe and rig for its peak.
    pub limits: Vec<Check>,
}

/// The reason why there is no result.
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
    #[error("the plan has no set points, or a series no samples")]
    Nothing,
}

impl DynamicPlan {
    /// Returns the events to solve, event after event, friction after friction, down the hole.
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
    /// Solves an event; `None` where `goes_on` returned `false` on the way.
    ///
    /// # Errors
    /// The reason why there is no result.
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
        let pump_pressure_Pa = pressures
            .and_then(|pressure| peak(&pressure, Toward::More))
            .filter(|_| event.circulates());
        let gel = plan.gel_strength_Pa.filter(|_| event.circulates());
        let gel = gel.map(|strength_Pa| gel_break(&model, bit_depth_m, strength_Pa));
        let pump_Pa = pump_pressure_Pa.map_or(0.0, |pressure| pressure.peak);
        let pump_Pa = gel.map_or(pump_Pa, |gel| gel.pressure_Pa().max(pump_Pa));
        let profile = extremes.in_profile(&outcome.nodes);
        let hydraulics = outcome
            .hydraulics
            .map(|hydraulic| Hydraulics { pump_pressure_Pa: pump_Pa, ..hydraulic });
        let solution = Solution { profile: &profile, hydraulics, ..(&outcome).into() };
        let found = self.judge().limits(&model, &steady(event, &operation), &solution);
        let is_its = |check: &Check| bears_on(event, check.kind);
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

/// Returns the operation for the limits: a string that breaks circulation does not turn.
fn steady(event: Event, operation: &Operation) -> Operation {
    let speed = if event.turns() { operation.rotary_speed_rad_per_s } else { 0.0 };
    Operation { rotary_speed_rad_per_s: speed, ..*operation }
}
