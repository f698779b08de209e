//! Range of a map of torsional stability.

use std::f64::consts::TAU;

use super::StabilityError;
use wholestring::operation::Operation;

/// Even steps from one value to another, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StabilityRange {
    /// The least.
    pub from: f64,
    /// The largest.
    pub to: f64,
    /// Number of values.
    pub values: usize,
}

impl StabilityRange {
    /// Its values.
    pub fn values(&self) -> Vec<f64> {
        let step = (self.to - self.from) / (self.values - 1) as f64;
        (0..self.values).map(|i| self.from + step * i as f64).collect()
    }

    fn check(&self, name: &'static str) -> Result<(), StabilityError> {
        let sound = self.from > 0.0 && self.to > self.from && self.to.is_finite();
        if sound && self.values > 1 { Ok(()) } else { Err(StabilityError::Range(name)) }
    }
}

/// Range of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StabilitySettings {
    /// Rotary speeds, rad/s.
    pub speeds_rad_per_s: StabilityRange,
    /// Weights on bit, N.
    pub weights_N: StabilityRange,
    /// Fastest motion that is looked at, Hz.
    pub highest_Hz: f64,
}

impl StabilitySettings {
    /// A fifth to twice the operation's speed and weight, motions up to 25 Hz.
    pub fn around(operation: &Operation) -> Self {
        let around =
            |value: f64| StabilityRange { from: 0.2 * value, to: 2.0 * value, values: VALUES };
        Self {
            speeds_rad_per_s: around(operation.rotary_speed_rad_per_s),
            weights_N: around(operation.weight_on_bit_N),
            highest_Hz: HIGHEST_HZ,
        }
    }

    pub(super) fn check(&self) -> Result<(), StabilityError> {
        self.speeds_rad_per_s.check("the range of rotary speeds")?;
        self.weights_N.check("the range of weights on bit")?;
        if self.highest_Hz > 0.0 && self.highest_Hz.is_finite() {
            Ok(())
        } else {
            Err(StabilityError::Range("the highest frequency"))
        }
    }

    pub(super) fn highest_rad_per_s(&self) -> f64 {
        TAU * self.highest_Hz
    }
}

/// Speeds and weights of a map by default: the operation's own are among them.
const VALUES: usize = 19;

/// Fastest motion in the search by default, Hz.
pub const HIGHEST_HZ: f64 = 25.0;
