//! What hook load and torque may come to at the surface.

use wholestring::outcome::QuantityKind;
use wholestring_judge::{CheckKind, LimitSettings, surface_limits};
use wholestring_plan::{Broomstick, FrictionLevel};
use wholestring_report as report;
use wholestring_results::PlanSurfaceLimit;

/// Of the rig and of the topmost component; none of a string that fits no depth.
pub(super) fn limits(of: &Broomstick, settings: &LimitSettings) -> Vec<PlanSurfaceLimit> {
    let setup = of.setup(FrictionLevel::Expected);
    let deepest_m = of.depths_m().last().copied().unwrap_or_default();
    // Why there is no string stands beside each of its points.
    let Ok(model) = setup.at(deepest_m) else { return Vec::new() };
    let limits = surface_limits(&model, settings).into_iter().map(|of| PlanSurfaceLimit {
        kind: of.kind.name().to_owned(),
        component: of.component,
        is_torque: of.kind.quantity() == QuantityKind::Torque,
        capacity: of.capacity,
        required: of.required,
        allowed: of.allowed,
    });
    limits.collect()
}

/// The same as pages show it.
pub(super) fn shown(of: &PlanSurfaceLimit) -> report::PlanSurfaceLimit {
    let title = title(&of.kind).to_owned();
    report::PlanSurfaceLimit { title, is_torque: of.is_torque, allowed: of.allowed }
}

/// What a line of a kind is called.
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
