//! Wear of casing by the string that turns in it.
//!
//! The volume that goes is the wear factor times side force times sliding distance; it leaves a [groove](Groove)
//! with the radius of what rubs. [`CasingWear`] sums a campaign along the casing. Theory and sources:
//! `docs/src/theory/casing-wear.md`.

mod campaign;
mod casing;
mod groove;

pub use campaign::{CasingWear, Worn};
pub use casing::{CasingError, DEFAULT_WEAR_FACTOR_PER_PA, WearFactors, WearRow, WornPipe};
pub use groove::Groove;

/// Volume of casing that goes per metre, m³/m, by the linear model of wear factors: `V = F q s`, with the wear
/// factor `F`, 1/Pa, the side force per metre of string `q`, N/m, and the sliding distance `s`, m.
///
/// Where the string passes through, each metre of casing sees tool joints a part of the time under so much more
/// force that the two cancel: `q` is per metre of pipe, not that of a joint.
pub fn worn_m3_per_m(wear_factor_per_Pa: f64, side_force_N_per_m: f64, sliding_m: f64) -> f64 {
    wear_factor_per_Pa * side_force_N_per_m * sliding_m
}

/// The same of a work of friction per metre of hole, J/m, that was done with a coefficient of friction:
/// `V = F W/μ`. Nothing where there is no friction: then no work says what slid.
pub fn worn_by_work_m3_per_m(wear_factor_per_Pa: f64, work_J_per_m: f64, friction: f64) -> f64 {
    if friction > 0.0 { wear_factor_per_Pa * work_J_per_m / friction } else { 0.0 }
}
