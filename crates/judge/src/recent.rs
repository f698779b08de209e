//! Motion of a live string over the last seconds.

use wholestring::{dynamics::Indicators, outcome::Profile};

/// Motion of a live string over the last seconds. Samples that are not known are not numbers.
#[derive(Debug, Clone, Copy)]
pub struct Recent<'a> {
    /// Depth of each node, and the largest tension, torque and von Mises stress of that time.
    pub largest: &'a Profile,
    /// Present effective tension of each node, N.
    pub tension_N: &'a [f64],
    /// Hook load without the block, N.
    pub hook_load_N: &'a [f64],
    /// Surface torque, N·m.
    pub surface_torque_N_m: &'a [f64],
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: &'a [f64],
    /// Set point of the rotary speed, rad/s.
    pub rotary_speed_set_rad_per_s: &'a [f64],
    /// Discharge pressure of the pump, Pa.
    pub pump_pressure_Pa: &'a [f64],
    /// Weight on bit, N.
    pub weight_on_bit_N: &'a [f64],
    /// Set point of the autodriller, N.
    pub weight_on_bit_set_N: &'a [f64],
    /// Time between two samples, s.
    pub sample_s: f64,
    /// Stick-slip and whirl.
    pub indicators: &'a Indicators,
}
