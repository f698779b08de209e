//! Survey stations.

use nalgebra::Vector3;
use serde::Serialize;

/// One survey station.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Station {
    /// Measured depth along the hole, m.
    pub md_m: f64,
    /// Inclination from vertical, rad.
    pub inclination_rad: f64,
    /// Azimuth from north, clockwise seen from above, rad.
    pub azimuth_rad: f64,
}

impl Station {
    /// Direction of the hole: unit vector, north, east, down.
    pub fn tangent(&self) -> Vector3<f64> {
        let (sin_inc, cos_inc) = libm::sincos(self.inclination_rad);
        let (sin_azi, cos_azi) = libm::sincos(self.azimuth_rad);
        Vector3::new(sin_inc * cos_azi, sin_inc * sin_azi, cos_inc)
    }

    /// Dogleg between two stations, rad: the angle between their directions, 0 to π.
    pub fn dogleg_rad(&self, other: &Self) -> f64 {
        angle_between(&self.tangent(), &other.tangent())
    }
}

/// Angle between two unit vectors, rad, without the loss of digits of `acos` near 0 and π
/// (W. Kahan: twice the arc tangent of the ratio of the difference to the sum).
pub(super) fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    2.0 * libm::atan2((b - a).norm(), (b + a).norm())
}

// Interpolation of the hole's axis between survey stations.

/// Interpolation of the curve between stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Interpolation {
    /// Circular arcs: the industry's standard. The curvature jumps at stations.
    MinimumCurvature,
    /// A curve with continuous curvature through the same directions.
    Spline,
}
