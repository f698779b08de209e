//! What the rig can carry and turn.

use super::{Finding, Kind, Level};
use crate::rig::Rig;

/// A load beyond this part of the hoist's capacity is reported.
const HEAVY: f64 = 0.9;

/// A torque beyond this part of the rated one is reported.
const MUCH: f64 = 0.8;

/// Hook loads, N, of which the mean and the largest count, against the hoist's capacity; with the
/// block where its weight is known.
pub fn hoist(rig: &Rig, hook_load_N: [f64; 2]) -> Option<Finding> {
    let capacity_N = rig.hoist_capacity_N?;
    let [mean_N, largest_N] = hook_load_N.map(|load| load + rig.block_weight_N.unwrap_or(0.0));
    let level = if mean_N > capacity_N {
        Level::Error
    } else if largest_N > HEAVY * capacity_N {
        Level::Warning
    } else {
        return None;
    };
    Some(Finding::new(Kind::HoistOverloaded, level).value(largest_N).limit(capacity_N))
}

/// Magnitudes of the surface torque, N·m, of which the mean and the largest count, against the top
/// drive's rated torque.
pub fn top_drive(rig: &Rig, torque_N_m: [f64; 2]) -> Option<Finding> {
    let rated_N_m = rig.top_drive_torque_N_m?;
    let [mean_N_m, largest_N_m] = torque_N_m;
    let level = if mean_N_m > rated_N_m {
        Level::Error
    } else if largest_N_m > rated_N_m {
        Level::Warning
    } else if largest_N_m > MUCH * rated_N_m {
        Level::Note
    } else {
        return None;
    };
    Some(Finding::new(Kind::TopDriveOverloaded, level).value(largest_N_m).limit(rated_N_m))
}
