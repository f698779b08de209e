//! Limits of hoist, top drive and pump.

use wholestring::model::Model;

use super::{
    LimitKind, LimitSettings, LoadCheck,
    limit::{Limits, Missing},
    loads::Loads,
};

/// Adds the limits of the rig.
pub fn limits(model: &Model, loads: &Loads<'_>, settings: &LimitSettings, found: &mut Limits) {
    let rig = &model.rig;
    let hangs_N = loads.hook_load_N + rig.block_weight_N.unwrap_or(0.0);
    let torque_N_m = loads.surface_torque_N_m;
    let peak_N_m = rig.top_drive_peak_torque_N_m;
    let mut check = |kind, load: f64, capacity: Option<f64>, missing| match capacity {
        Some(capacity) => {
            found.limits.extend(LoadCheck::new(kind, load, capacity, &settings.factors))
        }
        None => found.lacks(kind, None, missing),
    };
    check(LimitKind::Hoist, hangs_N, rig.hoist_capacity_N, Missing::HoistCapacity);
    check(LimitKind::TopDrive, torque_N_m, rig.top_drive_torque_N_m, Missing::TopDriveTorque);
    check(LimitKind::TopDrivePeak, torque_N_m, peak_N_m, Missing::TopDrivePeakTorque);
    let pump_Pa = loads.pump_pressure_Pa;
    let (limit_Pa, missing) = match (pump_Pa, rig.pump_pressure_limit_Pa) {
        (_, None) => (None, Missing::PumpPressureLimit),
        (None, Some(_)) => (None, Missing::Rheology),
        (Some(_), limit_Pa) => (limit_Pa, Missing::Rheology),
    };
    check(LimitKind::PumpPressure, pump_Pa.unwrap_or(0.0), limit_Pa, missing);
}
