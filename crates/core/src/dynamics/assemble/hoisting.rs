//! State of the hoist at the beginning of a run.

use crate::{
    dynamics::settings::{DynamicsSettings, HoistControl, schedule::HoistSetPoint},
    operation::Operation,
};

/// Returns the hoist's motion at time zero and the resulting axial velocity of the string, m/s.
pub fn hoisting(operation: &Operation, settings: &DynamicsSettings) -> (HoistControl, f64) {
    let start = settings.schedule.at_time_zero(operation);
    let own = settings.bit.axial_velocity_m_per_s(
        operation,
        start.weight_on_bit_N,
        start.rotary_speed_rad_per_s,
    );
    let usual = if operation.kind.on_bottom() {
        HoistControl::Autodriller
    } else {
        HoistControl::BlockVelocity(own)
    };
    let control = match settings.schedule.hoist_at_time_zero() {
        Some(HoistSetPoint::BlockVelocity(velocity)) => HoistControl::BlockVelocity(velocity),
        Some(HoistSetPoint::WeightOnBit(_)) => HoistControl::Autodriller,
        None => settings.hoist_control.unwrap_or(usual),
    };
    match control {
        HoistControl::BlockVelocity(velocity) => (control, velocity),
        _ => (control, own),
    }
}
