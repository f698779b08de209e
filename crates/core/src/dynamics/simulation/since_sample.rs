//! Sums between two samples.

use serde::{Deserialize, Serialize};

use crate::{dynamics::boundary::bit::BitStep, simd::vector::Vector};

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

impl SinceSample {
    /// Adds the bit's results in `part` of a step; `high` and `right` are the directions across the
    /// hole there.
    pub(super) fn add_bit(
        &mut self,
        bit: &BitStep,
        high: Vector<f64>,
        right: Vector<f64>,
        part: f64,
    ) {
        self.weight_on_bit += part * bit.weight_on_bit_N;
        self.bit_torque += part * bit.torque_N_m;
        self.bit_high += part * bit.force_N.dot(high);
        self.bit_right += part * bit.force_N.dot(right);
        self.bit_moment += part * bit.moment_N_m;
        self.depth_of_cut += part * bit.depth_of_cut_m;
        self.rate_of_penetration += part * bit.rate_of_penetration_m_per_s;
        self.motor_speed += part * bit.motor_speed_rad_per_s;
    }
}
