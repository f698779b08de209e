//! Loads of string and rig in operations with the expected friction only.

use wholestring::{
    operation::Operation,
    outcome::Solution,
    statics::{soft::SoftString, stiff},
};

use wholestring_judge::{Checks, NoAnswer};

use super::{Broomstick, Statics};
use crate::FrictionLevel;

/// Loads of an operation at the surface, and its limits.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpectedLoads {
    /// Hook load, N.
    pub hook_load_N: f64,
    /// Torque at the surface, N·m.
    pub surface_torque_N_m: f64,
    /// Its limits.
    pub limits: Checks,
}

impl Broomstick {
    /// Returns the loads of operations with the expected friction by a model with their bit at a
    /// depth, m; the same as those of their [points](Self::solve), in less time. Operations without
    /// a result have the reason.
    pub fn expected_loads(
        &self,
        by: Statics,
        bit_depth_m: f64,
        operations: &[Operation],
    ) -> Vec<Result<ExpectedLoads, NoAnswer>> {
        let here = |operation: &Operation| Operation { bit_depth_m, ..*operation };
        let none = |why: NoAnswer| operations.iter().map(|_| Err(why.clone())).collect();
        let model = match self.setup(FrictionLevel::Expected).at(bit_depth_m) {
            Ok(model) => model,
            Err(error) => return none(error.into()),
        };
        match by {
            Statics::Soft => {
                let string = match SoftString::new(&model, bit_depth_m, &self.soft) {
                    Ok(string) => string,
                    Err(error) => return none(error.into()),
                };
                let loads = |operation: Operation| {
                    let found = string.loads(&operation)?;
                    Ok(ExpectedLoads {
                        hook_load_N: found.hook_load_N,
                        surface_torque_N_m: found.surface_torque_N_m,
                        limits: self.judge.soft_limits(&model, &operation, &found),
                    })
                };
                operations.iter().map(here).map(loads).collect()
            }
            Statics::Stiff => {
                let loads = |operation: Operation| {
                    let found = stiff::equilibrium(&model, &operation, &self.stiff)?;
                    let found = found.profile(&model, &operation);
                    let solution = Solution::from(&found);
                    Ok(ExpectedLoads {
                        hook_load_N: solution.scalars.hook_load_N,
                        surface_torque_N_m: solution.scalars.surface_torque_N_m,
                        limits: self.judge.limits(&model, &operation, &solution),
                    })
                };
                operations.iter().map(here).map(loads).collect()
            }
        }
    }
}
