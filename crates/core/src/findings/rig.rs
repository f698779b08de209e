//! What the rig can carry, turn and pump.

use super::{Finding, Kind, Level};
use crate::rig::Rig;

/// A load beyond this part of the hoist's capacity is reported, and a pressure beyond this part of
/// the pump's limit.
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
/// drive's rated torque and, where it is known, its peak torque, which it gives for a short time.
pub fn top_drive(rig: &Rig, torque_N_m: [f64; 2]) -> Option<Finding> {
    let peak_N_m = rig.top_drive_peak_torque_N_m;
    let rated_N_m = rig.top_drive_torque_N_m.or(peak_N_m)?;
    let [mean_N_m, largest_N_m] = torque_N_m;
    let peak_N_m = peak_N_m.filter(|peak_N_m| largest_N_m > *peak_N_m);
    let level = if mean_N_m > rated_N_m || peak_N_m.is_some() {
        Level::Error
    } else if largest_N_m > rated_N_m && rig.top_drive_peak_torque_N_m.is_none() {
        Level::Warning
    } else if largest_N_m > MUCH * rated_N_m {
        Level::Note
    } else {
        return None;
    };
    let limit_N_m = peak_N_m.unwrap_or(rated_N_m);
    Some(Finding::new(Kind::TopDriveOverloaded, level).value(largest_N_m).limit(limit_N_m))
}

/// Pressures that the pump delivers at, Pa, of which the mean and the largest count, against the
/// limit.
pub fn pump(rig: &Rig, pressure_Pa: [f64; 2]) -> Option<Finding> {
    let limit_Pa = rig.pump_pressure_limit_Pa?;
    let [mean_Pa, largest_Pa] = pressure_Pa;
    let level = if mean_Pa > limit_Pa {
        Level::Error
    } else if largest_Pa > HEAVY * limit_Pa {
        Level::Warning
    } else {
        return None;
    };
    Some(Finding::new(Kind::PumpPressure, level).value(largest_Pa).limit(limit_Pa))
}
