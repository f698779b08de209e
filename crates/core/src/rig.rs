//! The rig: hoist and top drive.

pub mod catalogue;

use serde::Serialize;

/// Limits of the rig: load, push, torque and pump pressure. `None` means that no limit was given.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Rig {
    /// Weight of travelling block and top drive, N. Never part of the reported hook load.
    pub block_weight_N: Option<f64>,
    /// Largest load that the hoist carries, N, block included.
    pub hoist_capacity_N: Option<f64>,
    /// Largest force with which the rig pushes the string into the hole, N, the block's weight
    /// apart: of a snubbing unit, an injector head, a pull-down. `None` of a rig that only carries.
    pub snubbing_force_N: Option<f64>,
    /// Rated (continuous) torque of the top drive, N·m.
    pub top_drive_torque_N_m: Option<f64>,
    /// Largest torque that the top drive gives for a short time, N·m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub top_drive_peak_torque_N_m: Option<f64>,
    /// Largest pressure of pumps, standpipe and hoses, Pa.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pump_pressure_limit_Pa: Option<f64>,
}

impl Rig {
    /// Maximum force with which the rig pushes the string into the hole, N, without the block's
    /// weight.
    pub fn push_N(&self) -> f64 {
        self.snubbing_force_N.unwrap_or(0.0)
    }

    /// The same with the weight of the block, where that is known.
    pub fn push_with_block_N(&self) -> f64 {
        self.push_N() + self.block_weight_N.unwrap_or(0.0)
    }
}
