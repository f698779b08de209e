//! Wear by the dynamics' work of friction.

use std::ops::ControlFlow;

use wholestring::{
    dynamics::{DynamicsSettings, Schedule, Simulation},
    operation::Operation,
};

use super::{DynamicPlan, NoDynamics};
use crate::{Broomstick, FrictionLevel, Share};

/// An operation of the campaign whose wear is the dynamics', with the depth of its bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearTask {
    /// The operation.
    pub operation: Operation,
}

impl DynamicPlan {
    /// What wears, operation after operation, down the hole. What the campaign has at the deepest depth alone is
    /// looked at there.
    pub fn wear_tasks(&self, campaign: &crate::Campaign) -> Vec<WearTask> {
        let depths = |of: &Operation| {
            let of = *of;
            self.bit_depths_m
                .iter()
                .map(move |bit_depth_m| Operation { bit_depth_m: *bit_depth_m, ..of })
        };
        let operations = self.wear.iter().flat_map(depths);
        let wears = |of: &Operation| campaign.duration_near_s(of, &self.bit_depths_m).is_some();
        operations.filter(wears).map(|operation| WearTask { operation }).collect()
    }
}

impl Broomstick {
    /// What an operation takes of the casings by the dynamics' work of friction, with the friction that is
    /// expected; none where `goes_on` said no on the way, or where there is no campaign.
    ///
    /// # Errors
    /// Why it has no answer.
    pub fn solve_wear(
        &self,
        task: &WearTask,
        plan: &DynamicPlan,
        dynamics: &DynamicsSettings,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Option<Share>, NoDynamics> {
        let Some(campaign) = self.campaign() else { return Ok(None) };
        let operation = &task.operation;
        let model = self.setup(FrictionLevel::Expected).at(operation.bit_depth_m)?;
        // The case's schedule is that of its own run.
        let settings = DynamicsSettings {
            schedule: Schedule::default(),
            probes: Vec::new(),
            ..dynamics.clone()
        };
        let mut simulation = Simulation::new(&model, operation, &settings)?;
        let outcome = simulation.to_end_with(&mut |_: &Simulation| {
            if goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })?;
        if !goes_on() {
            return Ok(None);
        }
        Ok(campaign.share_by_work(&model, operation, &(&outcome).into(), &plan.bit_depths_m))
    }
}
