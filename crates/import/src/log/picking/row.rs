//! A row of a log without values that no sensor can give.

use std::ops::RangeInclusive;

use crate::log::{Quantity, Record};

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

/// Ranges of sensors of a rig, in the order of [`Row`]: null values such as -999.25 are outside them
/// in any logged unit, or are short drops of the hook load.
pub(super) const RANGES: [(Quantity, RangeInclusive<f64>); 7] = [
    // The deepest wells reach 15 km.
    (Quantity::BitDepth, 0.0..=2e4),
    (Quantity::HoleDepth, 0.0..=2e4),
    // Derricks lift 45 m; the zero is somewhere near the floor.
    (Quantity::BlockPosition, -10.0..=100.0),
    // The largest hoists carry 1250 tf.
    (Quantity::HookLoad, -5e5..=2e7),
    // The largest top drives deliver 150 kN·m.
    (Quantity::Torque, -5e5..=5e5),
    // 600 rev/min.
    (Quantity::RotarySpeed, -63.0..=63.0),
    (Quantity::WeightOnBit, -1e7..=1e7),
];

/// Values outside the range of their sensor.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Outside {
    pub(super) count: usize,
    /// The first of them, in SI.
    pub(super) first: f64,
}

/// Values outside their ranges, in the order of [`RANGES`].
pub(super) type AllOutside = [Outside; RANGES.len()];

impl Row {
    /// Converts a record to a row, without its impossible values, which are counted.
    pub(super) fn of(record: &Record, outside: &mut AllOutside) -> Self {
        let mut record = *record;
        for ((quantity, range), outside) in RANGES.iter().zip(outside) {
            let value = quantity.field(&mut record);
            if value.is_finite() && !range.contains(value) {
                if outside.count == 0 {
                    outside.first = *value;
                }
                outside.count += 1;
                *value = f64::NAN;
            }
        }
        Self {
            time_s: record.time_s,
            bit_depth_m: record.bit_depth_m,
            hole_depth_m: record.hole_depth_m,
            block_m: record.block_position_m,
            hook_load_N: record.hook_load_N,
            torque_N_m: record.torque_N_m,
            rotary_rad_per_s: record.rotary_speed_rad_per_s,
            weight_on_bit_N: record.weight_on_bit_N,
        }
    }

    /// Height of the bit above bottom, m.
    pub(super) fn height_m(&self) -> f64 {
        self.hole_depth_m - self.bit_depth_m
    }
}
