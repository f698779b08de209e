//! Results held against what the rig can carry and turn.

use wholestring::rig::Rig;
use wholestring_results::{OperationSummary, Summary};
use wholestring_units::{Dimension, UnitSet};

/// A line for every operation and model that asks more of the rig than it has; empty where no limit
/// was given. Of a dynamic model the largest value of the window counts.
pub(crate) fn warnings(summary: &Summary, rig: &Rig, units: UnitSet) -> String {
    let mut lines = String::new();
    for solved in &summary.operations {
        let mut hold = |quantity: &str, value, limit: Option<f64>, whose: &str, of: Dimension| {
            if let Some(limit) = limit.filter(|limit| value > *limit) {
                lines += &format!(
                    "warning: {} ({}): {quantity} of {} exceeds the {whose} of {}\n",
                    solved.operation.replace('_', " "),
                    solved.model.name(),
                    of.format(value, units),
                    of.format(limit, units),
                );
            }
        };
        let block_N = rig.block_weight_N.unwrap_or(0.0);
        hold(
            if block_N > 0.0 {
                "hook load with block"
            } else {
                "hook load"
            },
            largest(solved, "hook_load_N", solved.scalars.hook_load_N) + block_N,
            rig.hoist_capacity_N,
            "hoist's capacity",
            Dimension::Force,
        );
        let torque_N_m = solved.scalars.surface_torque_N_m;
        hold(
            "surface torque",
            largest(solved, "surface_torque_N_m", torque_N_m),
            rig.top_drive_torque_N_m,
            "top drive's rated torque",
            Dimension::Torque,
        );
    }
    lines
}

/// The largest value of the window, or the only one.
fn largest(solved: &OperationSummary, key: &str, value: f64) -> f64 {
    let statistic = solved.statistics.as_ref().and_then(|all| all.get(key));
    statistic.map_or(value, |statistic| statistic.max)
}
