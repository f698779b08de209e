//! Limits of hook load and torque at the surface.

use wholestring::outcome::QuantityKind;
use wholestring_judge::{CheckKind, LimitSettings, surface_limits};
use wholestring_plan::{Broomstick, FrictionLevel};
use wholestring_report as report;
use wholestring_results::PlanSurfaceLimit;

/// Limits of the rig and of the topmost component; empty if the string fits no depth.
pub(super) fn limits(broomstick: &Broomstick, settings: &LimitSettings) -> Vec<PlanSurfaceLimit> {
    let setup = broomstick.setup(FrictionLevel::Expected);
    let deepest_m = broomstick.depths_m().last().copied().unwrap_or_default();
    // The reason is given with each of its points.
    let Ok(model) = setup.at(deepest_m) else { return Vec::new() };
    let limits =
        surface_limits(&model, settings).into_iter().map(|surface_limit| PlanSurfaceLimit {
            kind: surface_limit.kind.name().to_owned(),
            component: surface_limit.component,
            is_torque: surface_limit.kind.quantity() == QuantityKind::Torque,
            capacity: surface_limit.capacity,
            required: surface_limit.required,
            allowed: surface_limit.allowed,
        });
    limits.collect()
}

/// The same in the form of the page.
pub(super) fn shown(limit: &PlanSurfaceLimit) -> report::PlanSurfaceLimit {
    let title = title(&limit.kind).to_owned();
    report::PlanSurfaceLimit { title, is_torque: limit.is_torque, allowed: limit.allowed }
}

/// Title of a line of this kind.
pub(super) fn title(kind: &str) -> &str {
    match CheckKind::named(kind) {
        Some(CheckKind::Hoist) => "hoist",
        Some(CheckKind::Tension) => "pipe, tension",
        Some(CheckKind::Torsion) => "pipe, torsion",
        Some(CheckKind::MakeUp) => "make-up",
        Some(CheckKind::TopDrive) => "top drive",
        Some(CheckKind::TopDrivePeak) => "top drive, peak",
        _ => kind,
    }
}
