//! Range of a map of torsional stability.

use std::f64::consts::TAU;

use wholestring::{dynamics::SetupError, operation::Operation, statics::soft::SoftError};

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

// Why there is no map.

/// Why linear vibration about steady rotation cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StabilityError {
    /// The string does not turn on bottom.
    #[error("torsional stability is that of a string that drills and turns: kind = \"drill\"")]
    NotDrilling,
    /// A bit on solid rock.
    #[error(
        "a bit on solid rock has no law with known slopes: measure it with a bit test, and give \
         its table to the bit"
    )]
    SolidRock,
    /// Nothing in the case falls with speed, and every point of the map is stable.
    #[error(
        "neither the torque of the bit nor the axial friction falls with speed in this case, \
        and its weights are too small for the rate of penetration to drive stick-slip (`heaviest` of \
        [modes]), so that every speed and weight of the map is stable. Give the hole a \
        static friction above the kinetic one, such as friction = {{ kinetic = {kinetic}, static = \
        {at_rest} }}, or the bit a law that loses torque with speed (`bit.law` \"regenerative\" or \
        \"table\"); `modes.static_over_kinetic = {ratio}` assumes that ratio for this map alone"
    )]
    NothingFalls {
        /// Kinetic friction of the deepest section.
        kinetic: f64,
        /// A usual static friction to go with it.
        at_rest: f64,
        /// A usual ratio of the two.
        ratio: f64,
    },
    /// The bit does not turn.
    #[error("the bit does not turn: its motor stalls, or the string does not turn")]
    Stands,
    /// A user-defined controller or friction law.
    #[error("a user-defined {0} has no known slopes")]
    Custom(&'static str),
    /// A range that holds nothing.
    #[error("{0} must be positive, the second above the first, in two steps at least")]
    Range(&'static str),
    /// Settings that no run can use.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The string cannot be laid in its hole.
    #[error(transparent)]
    Soft(#[from] SoftError),
}
