//! `hoist` and `top_drive` in the record of a run.

use wholestring::{
    dynamics::{DynamicsSettings, HoistControl, TopDriveSettings},
    operation::Operation,
};

use super::fields::Fields;
use crate::rig::TUNED_LIFT;

/// The control by its word, as chosen; `null` leaves it to the operation. The numbers of a control
/// that is never active are `null`.
pub(super) fn hoist(
    dynamics: &DynamicsSettings,
    operations: &[Operation],
    control: Option<&str>,
) -> Fields {
    let tuned = control == Some(TUNED_LIFT);
    let on_bottom = operations.iter().any(|one| one.kind.on_bottom());
    let by_itself = dynamics.hoist_control.is_none() && !tuned && on_bottom;
    let automatic = by_itself
        || dynamics.hoist_control == Some(HoistControl::Autodriller)
        || dynamics.schedule.holds_a_weight();
    let autodriller = Fields::of(&dynamics.autodriller);
    let (velocity, load) = match dynamics.hoist_control {
        Some(HoistControl::BlockVelocity(velocity)) => (Some(velocity), None),
        Some(HoistControl::HookLoad(load)) => (None, Some(load)),
        Some(HoistControl::Autodriller) | None => (None, None),
    };
    Fields::of(&dynamics.hoist_line)
        .renamed([("block_mass_kg", "mass_kg")])
        .and(if automatic { autodriller } else { autodriller.nulled() })
        .with("control", control)
        .with("block_velocity_m_per_s", velocity)
        .with("hook_load_N", load)
        .with("tolerance", tuned.then_some(dynamics.lift_tolerance))
}

/// The settings of the drive in a run; values that it derives from the string are `null`.
pub(super) fn top_drive(drive: &TopDriveSettings) -> Fields {
    Fields::tagged("control", drive).spread_variant("controller", "control")
}
