//! What is summed between two samples.

use serde::{Deserialize, Serialize};

/// Scalars summed since the last sample.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub(super) struct SinceSample {
    pub(super) steps: u64,
    pub(super) hook_load: f64,
    pub(super) surface_torque: f64,
    pub(super) weight_on_bit: f64,
    pub(super) bit_torque: f64,
    pub(super) bit_high: f64,
    pub(super) bit_right: f64,
    pub(super) bit_moment: f64,
    pub(super) depth_of_cut: f64,
    pub(super) rate_of_penetration: f64,
    pub(super) motor_speed: f64,
}
