//! The rig: hoist and top drive.

use serde::Serialize;

/// What the rig can carry and turn. `None` means that no limit was given.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Rig {
    /// Weight of travelling block and top drive, N. Never part of the reported hook load.
    pub block_weight_N: Option<f64>,
    /// Largest load that the hoist carries, N, block included.
    pub hoist_capacity_N: Option<f64>,
    /// Rated (continuous) torque of the top drive, N·m.
    pub top_drive_torque_N_m: Option<f64>,
}
