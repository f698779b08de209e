//! Fatigue of pipe that turns in doglegs.
//!
//! Each revolution bends every fibre once to and fro, by the local curvature of the pipe, which at
//! its tool joints exceeds that of the hole. [`rows`] returns the damage per hour and the
//! permissible dogleg, [`Damage`] sums a campaign by Miner's rule. Theory and sources:
//! `docs/src/theory/fatigue.md`.

mod damage;
mod rate;
mod sn_curve;

pub use damage::{CELL_M, Damage, DamageRow};
pub use rate::{FatigueRow, FatigueSettings, rows};
pub use sn_curve::{
    EnduranceCurve, SnCurve, equivalent_amplitude_Pa, minimum_tensile_strength_Pa,
    permissible_dogleg_rad_per_m,
};
