//! Wear from the friction work of the dynamics.

use std::ops::ControlFlow;

use wholestring::{
    dynamics::{DynamicsSettings, Schedule, Simulation},
    operation::Operation,
};

use super::{DynamicPlan, NoDynamics};
use crate::{Broomstick, FrictionLevel, Share};

/// An operation of the campaign whose wear is computed by the dynamics, with the depth of its bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearTask {
    /// The operation.
    pub operation: Operation,
}

impl DynamicPlan {
    /// Returns the wear tasks, operation after operation, down the hole. An operation that the
    /// campaign has only at the deepest depth is evaluated there.
    pub fn wear_tasks(&self, campaign: &crate::Campaign) -> Vec<WearTask> {
        let depths = |operation: &Operation| {
            let template = *operation;
            self.bit_depths_m
                .iter()
                .map(move |bit_depth_m| Operation { bit_depth_m: *bit_depth_m, ..template })
        };
        let operations = self.wear.iter().flat_map(depths);
        let wears = |operation: &Operation| {
            campaign.duration_near_s(operation, &self.bit_depths_m).is_some()
        };
        operations.filter(wears).map(|operation| WearTask { operation }).collect()
    }
}

impl Broomstick {
    /// Returns the casing wear of an operation from the friction work of the dynamics, with the
    /// expected friction; `None` where `goes_on` returned `false` on the way, or without a
    /// campaign.
    ///
    /// # Errors
    /// The reason why there is no result.
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
        // The case's schedule applies to its own run only.
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
