//! Whether a string that slides down gets there.

use wholestring::{
    model::Model,
    operation::Operation,
    statics::buckling::{Pushed, push_through, segments, weight_at_bit_N},
};

use super::{LimitKind, LimitSettings, LoadCheck, limit::Limits, loads::Loads};

/// Adds the limit of a string that goes down without rotation: its friction and the weight on bit, against
/// the same friction and the weight that would arrive at the bit with the whole string slacked off, block and
/// rig pushing. What a helix presses against the wall takes from what arrives.
pub fn limit(
    model: &Model,
    operation: &Operation,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    found: &mut Limits,
) {
    if !operation.slides_down() {
        return;
    }
    let rig = &model.rig;
    let push_N = rig.snubbing_force_N.unwrap_or(0.0) + rig.block_weight_N.unwrap_or(0.0);
    let segments = segments(model, operation, &loads.profile.md_m);
    let arrives_N = weight_at_bit_N(&segments, push_N, model.buckling);
    let drag_N = loads.axial_friction_N.abs();
    let asked_N = operation.weight_on_bit_now_N();
    let driven_N = (drag_N + arrives_N).max(0.0);
    let limit = LoadCheck::new(LimitKind::LockUp, drag_N + asked_N, driven_N, &settings.factors);
    let place = match push_through(&segments, asked_N, model.buckling) {
        Pushed::LocksUp(above_bit_m) => {
            Some((operation.bit_depth_m - above_bit_m, model.string.component_at(above_bit_m).0))
        }
        Pushed::Through(_) => None,
    };
    found.limits.extend(limit.map(|limit| match place {
        Some((md_m, component)) => limit.at(Some(component), md_m),
        None => limit,
    }));
}
