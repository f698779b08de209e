//! A row of the map: a weight on bit at all speeds.

use super::{pressing::LiesBy, roots::Stability};

/// A speed and a weight, and the stability of small vibrations there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StabilityPoint {
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Stability of small vibrations.
    pub stability: Stability,
}

/// From which rotary speed on steady rotation is stable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Threshold {
    /// From the slowest of the range.
    Everywhere,
    /// From this one, rad/s.
    From(f64),
    /// Not even at the fastest of the range.
    Nowhere,
}

/// A weight on bit at all speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityLine {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// By speed.
    pub points: Vec<StabilityPoint>,
    /// From which speed on it is stable.
    pub threshold: Threshold,
    /// Torque at the top while it turns steadily, N·m.
    pub surface_torque_N_m: f64,
    /// Whether that is more than the top drive gives.
    pub stalls: bool,
    /// Method that provided the contact of the string.
    pub lies_by: LiesBy,
}
