//! Limits of hook load and torque at the surface.

use wholestring::outcome::QuantityKind;
use wholestring_judge::{LimitSettings, surface_limits};
use wholestring_plan::{Broomstick, FrictionLevel};
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
