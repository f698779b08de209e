//! Wear of casing by the string that turns in it.
//!
//! The worn volume is the wear factor times side force times sliding distance; it forms a
//! [groove](Groove) with the radius of the contacting part. [`CasingWear`] sums a campaign along
//! the casing. Theory and sources: `docs/src/theory/casing-wear.md`.

mod campaign;
mod casing;
mod groove;

pub use campaign::{CasingWear, Worn};
pub use casing::{CasingError, DEFAULT_WEAR_FACTOR_PER_PA, WearFactors, WearRow, WornPipe};
pub use groove::Groove;

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
