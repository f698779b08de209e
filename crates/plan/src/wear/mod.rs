//! Wear of casing by the string that turns in it.
//!
//! The worn volume is the wear factor times side force times sliding distance; it forms a
//! [groove](Groove) with the radius of the contacting part. [`CasingWear`] sums a campaign along
//! the casing. Theory and sources: `docs/src/theory/casing-wear.md`.

mod campaign;
mod casing;

pub use campaign::{CasingWear, Worn};
pub use casing::{CasingError, DEFAULT_WEAR_FACTOR_PER_PA, WearFactors, WearRow, WornPipe};

use std::{convert::Infallible, f64::consts::PI};

use crate::root;

/// Returns the worn volume of casing per metre, m³/m, by the linear model of wear factors: `V = F q
/// s`, with the wear factor `F`, 1/Pa, the side force per metre of string `q`, N/m, and the sliding
/// distance `s`, m.
///
/// Where the string passes through, each metre of casing is in contact with tool joints only a part
/// of the time, under a force that is larger by the inverse of that part, so that the two cancel:
/// `q` is per metre of pipe, not that of a joint.
pub fn worn_m3_per_m(wear_factor_per_Pa: f64, side_force_N_per_m: f64, sliding_m: f64) -> f64 {
    wear_factor_per_Pa * side_force_N_per_m * sliding_m
}

/// Returns the same from a friction work per metre of hole, J/m, at a coefficient of friction: `V =
/// F W/μ`. Zero without friction, because then the work does not show the sliding distance.
pub fn worn_by_work_m3_per_m(wear_factor_per_Pa: f64, work_J_per_m: f64, friction: f64) -> f64 {
    if friction > 0.0 { wear_factor_per_Pa * work_J_per_m / friction } else { 0.0 }
}

// The groove that a tool joint wears into casing.

/// A groove: the part of a circle of the joint's radius that is in the casing outside its bore.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groove {
    /// Radius of the bore, m.
    pub bore_m: f64,
    /// Radius of the contacting part, m; less than that of the bore.
    pub joint_m: f64,
}

/// Returns `θ − sin θ cos θ`, without loss of precision where the angle is small: the segment of a
/// circle that half an angle `θ` of arc cuts off, over the square of the radius.
fn segment(angle: f64) -> f64 {
    if angle < 0.05 {
        // The next term is 2e-15 of the first.
        let square = angle * angle;
        let tail = 1.0 / 5.0 - square * (2.0 / 105.0 - square / 945.0);
        return 2.0 / 3.0 * angle * square * (1.0 - square * tail);
    }
    angle - libm::sin(angle) * libm::cos(angle)
}

impl Groove {
    /// Returns the distance from the bore's axis to the joint's for a depth of the groove, m.
    fn apart_m(&self, depth_m: f64) -> f64 {
        self.bore_m - self.joint_m + depth_m
    }

    /// Returns half of its width at the bore, m, by its depth: `√(d (2R − d))`, the bore's chord,
    /// with `d = h (2r − h)/2e` its height.
    pub fn half_width_m(&self, depth_m: f64) -> f64 {
        let height_m = depth_m * (2.0 * self.joint_m - depth_m) / (2.0 * self.apart_m(depth_m));
        (height_m * (2.0 * self.bore_m - height_m)).max(0.0).sqrt()
    }

    /// Returns its area, m², by its depth: the segment of the joint's circle beyond the chord, less
    /// that of the bore.
    pub fn area_m2(&self, depth_m: f64) -> f64 {
        if depth_m <= 0.0 {
            return 0.0;
        }
        let apart_m = self.apart_m(depth_m);
        let height_m = depth_m * (2.0 * self.joint_m - depth_m) / (2.0 * apart_m);
        let half_m = self.half_width_m(depth_m);
        let from_bore_m = self.bore_m - height_m;
        let of_joint = libm::atan2(half_m, from_bore_m - apart_m);
        let of_bore = libm::atan2(half_m, from_bore_m);
        self.joint_m.powi(2) * segment(of_joint) - self.bore_m.powi(2) * segment(of_bore)
    }

    /// Returns the depth of a groove from its area, m²; `None` for one that is larger than the
    /// circle of the contacting part, or of a part that fills the bore.
    pub fn depth_m(&self, area_m2: f64) -> Option<f64> {
        if !(self.joint_m > 0.0 && self.joint_m < self.bore_m) || area_m2.is_nan() {
            return None;
        }
        if area_m2 <= 0.0 {
            return Some(0.0);
        }
        let whole_m2 = PI * self.joint_m.powi(2);
        if area_m2 >= whole_m2 {
            return None;
        }
        // The area grows with the depth.
        let ends = [(0.0, -area_m2), (2.0 * self.joint_m, whole_m2 - area_m2)];
        let more_m2 = |depth_m: f64| Ok::<_, Infallible>(self.area_m2(depth_m) - area_m2);
        let Ok(depth_m) = root(more_m2, ends, 0.0);
        Some(depth_m)
    }
}
