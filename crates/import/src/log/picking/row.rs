//! A row of a log without values that no sensor can give.

use crate::log::Record;

/// Input of the picking: a row with a time. NaN where a sensor has no value or an impossible one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub(super) time_s: f64,
    pub(super) bit_depth_m: f64,
    pub(super) hole_depth_m: f64,
    pub(super) block_m: f64,
    pub(super) hook_load_N: f64,
    pub(super) torque_N_m: f64,
    pub(super) rotary_rad_per_s: f64,
    pub(super) weight_on_bit_N: f64,
}

/// Ranges of sensors of a rig: null values such as -999.25 are outside them in any logged unit, or
/// are short drops of the hook load.
mod can_be {
    use std::ops::RangeInclusive;
    /// The deepest wells reach 15 km.
    pub(super) const DEPTH_M: RangeInclusive<f64> = 0.0..=2e4;
    /// Derricks lift 45 m; the zero is somewhere near the floor.
    pub(super) const BLOCK_M: RangeInclusive<f64> = -10.0..=100.0;
    /// The largest hoists carry 1250 tf.
    pub(super) const HOOK_LOAD_N: RangeInclusive<f64> = -5e5..=2e7;
    /// The largest top drives deliver 150 kN·m.
    pub(super) const TORQUE_N_M: RangeInclusive<f64> = -5e5..=5e5;
    /// 600 rev/min.
    pub(super) const ROTARY_RAD_PER_S: RangeInclusive<f64> = -63.0..=63.0;
    pub(super) const WEIGHT_ON_BIT_N: RangeInclusive<f64> = -1e7..=1e7;
}

impl Row {
    /// Converts a record to a row, without its impossible values.
    pub(super) fn of(record: &Record) -> Self {
        let within = |value: f64, range: std::ops::RangeInclusive<f64>| {
            if range.contains(&value) { value } else { f64::NAN }
        };
        Self {
            time_s: record.time_s,
            bit_depth_m: within(record.bit_depth_m, can_be::DEPTH_M),
            hole_depth_m: within(record.hole_depth_m, can_be::DEPTH_M),
            block_m: within(record.block_position_m, can_be::BLOCK_M),
            hook_load_N: within(record.hook_load_N, can_be::HOOK_LOAD_N),
            torque_N_m: within(record.torque_N_m, can_be::TORQUE_N_M),
            rotary_rad_per_s: within(record.rotary_speed_rad_per_s, can_be::ROTARY_RAD_PER_S),
            weight_on_bit_N: within(record.weight_on_bit_N, can_be::WEIGHT_ON_BIT_N),
        }
    }

    /// Height of the bit above bottom, m.
    pub(super) fn height_m(&self) -> f64 {
        self.hole_depth_m - self.bit_depth_m
    }
}
