//! Limits of hoist, top drive and pump.
//!
//! In a dynamic run a rating is exceeded where the mean exceeds it, which is an error. A load that
//! exceeds it at times is a warning; within a known peak torque, a note.

use wholestring::{
    model::Model,
    operation::{Operation, OperationKind},
};

use crate::{
    Check, CheckKind, Checks, LimitSettings, Missing, Severity,
    loads::{Loads, SurfaceLoad},
};

/// Adds the limits of the rig.
pub fn limits(
    model: &Model,
    operation: &Operation,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    checks: &mut Checks,
) {
    let rig = &model.rig;
    let block_N = rig.block_weight_N.unwrap_or(0.0);
    let hangs_N = SurfaceLoad {
        mean: loads.hook_load_N.mean + block_N,
        largest: loads.hook_load_N.largest + block_N,
    };
    let torque_N_m = loads.surface_torque_N_m;
    let peak_N_m = rig.top_drive_peak_torque_N_m;
    let within_peak = peak_N_m.is_some_and(|peak_N_m| torque_N_m.largest <= peak_N_m);
    let at_times = |within_peak: bool| if within_peak { Severity::Note } else { Severity::Warning };
    let mut check = |kind, load: SurfaceLoad, capacity: Option<f64>, most, missing| {
        let Some(capacity) = capacity else {
            checks.lacks(kind, None, missing);
            return;
        };
        let required = settings.factors.required(kind);
        let check = Check::load(kind, load.largest, capacity, required);
        let lasts = load.mean > capacity;
        checks.checks.extend(check.map(|check| if lasts { check } else { check.at_most(most) }));
    };
    let hoist_N = rig.hoist_capacity_N;
    check(CheckKind::Hoist, hangs_N, hoist_N, Severity::Warning, Missing::HoistCapacity);
    let is_hook_load_alone = hoist_N.is_some() && rig.block_weight_N.is_none();
    let rated_N_m = rig.top_drive_torque_N_m;
    let most = at_times(within_peak);
    check(CheckKind::TopDrive, torque_N_m, rated_N_m, most, Missing::TopDriveTorque);
    let most = Severity::Error;
    check(CheckKind::TopDrivePeak, torque_N_m, peak_N_m, most, Missing::TopDrivePeakTorque);
    // The pressure of a string that trips is surge or swab; the pumps do not deliver it.
    if operation.kind.circulates() {
        let (pump_Pa, limit_Pa) = (loads.pump_pressure_Pa, rig.pump_pressure_limit_Pa);
        let missing =
            if limit_Pa.is_none() { Missing::PumpPressureLimit } else { Missing::Rheology };
        let load = pump_Pa.unwrap_or(SurfaceLoad { mean: 0.0, largest: 0.0 });
        let limit_Pa = pump_Pa.and(limit_Pa);
        check(CheckKind::PumpPressure, load, limit_Pa, Severity::Warning, missing);
    }
    if is_hook_load_alone {
        checks.lacks(CheckKind::Hoist, None, Missing::BlockWeight);
    }
    let start = breakaway_torque_N_m(model, operation, loads);
    if let (Some(start_N_m), Some(capacity_N_m)) = (start, peak_N_m.or(rated_N_m)) {
        let required = settings.factors.breakaway;
        checks.checks.extend(Check::load(CheckKind::Breakaway, start_N_m, capacity_N_m, required));
    }
}

/// Torque that starts a string off bottom turning, N·m: each stretch's friction torque times the
/// ratio of static to kinetic friction of its hole. `None` for another operation, and where both
/// are the same.
fn breakaway_torque_N_m(model: &Model, operation: &Operation, loads: &Loads<'_>) -> Option<f64> {
    if operation.kind != OperationKind::RotateOffBottom {
        return None;
    }
    let (md_m, torque_N_m) = (&loads.profile.md_m, &loads.profile.torque_N_m);
    let ratio = |md_m: f64| {
        let friction = model.well.hole.at(md_m).friction;
        if friction.kinetic > 0.0 { friction.at_rest / friction.kinetic } else { 1.0 }
    };
    let stretches = md_m.windows(2).zip(torque_N_m.windows(2));
    let mut differs = false;
    let wall_N_m: f64 = stretches
        .map(|(md_m, torque_N_m)| {
            let ratio = ratio(0.5 * (md_m[0] + md_m[1]));
            differs |= ratio > 1.0;
            ratio * (torque_N_m[0] - torque_N_m[1])
        })
        .sum();
    differs.then(|| (wall_N_m + torque_N_m.last().copied().unwrap_or(0.0)).abs())
}
