//! Rate of penetration against weight on bit, by straight segments.

use std::f64::consts::TAU;

/// A straight part of the rate at which a bit advances against its weight.
#[derive(Debug, Clone, Copy)]
pub(super) struct RateSegment {
    pub(super) from_N: f64,
    pub(super) to_N: f64,
    /// Rate at its beginning, m/s.
    pub(super) from_m_per_s: f64,
    /// Increase of the rate with the weight, m/s/N.
    pub(super) slope_m_per_s_per_N: f64,
}

impl RateSegment {
    pub(super) fn rate_m_per_s(&self, weight_N: f64) -> f64 {
        self.from_m_per_s + self.slope_m_per_s_per_N * (weight_N - self.from_N)
    }
}

/// Depth of cut per revolution at a rate of penetration, m.
pub(super) fn depth_of_cut_m(rate_m_per_s: f64, speed_rad_per_s: f64) -> f64 {
    if speed_rad_per_s > 0.0 { rate_m_per_s * TAU / speed_rad_per_s } else { 0.0 }
}
