//! What may still be pulled: of each component and of the hoist.

use wholestring::{model::Model, operation::Operation};

use super::{
    LimitKind, LimitSettings, LoadCheck, limit::Limits, loads::Loads, strengths::Strengths,
};
use crate::strength::margin_of_overpull_N;

/// Adds the margins of a string that hangs or is pulled off bottom: of each component where it has least,
/// its tensile yield over the required factor less its tension; of the hoist likewise, less the hook load
/// and the block.
pub fn limits(
    model: &Model,
    operation: &Operation,
    strengths: &Strengths<'_>,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    found: &mut Limits,
) {
    if operation.kind.on_bottom() || operation.axial_velocity_m_per_s() > 0.0 {
        return;
    }
    let LimitSettings { factors, overpull_N, .. } = settings;
    let limit = |margin_N: f64| {
        LoadCheck::new(LimitKind::Overpull, *overpull_N, margin_N.max(0.0), factors)
    };
    let mut least = vec![None::<LoadCheck>; strengths.count()];
    for row in 0..loads.rows() {
        for component in loads.components(row) {
            let Some(yield_N) = strengths.component(component).tensile_yield_N() else {
                continue;
            };
            let (part, tension_N) = (1.0 / factors.tension, loads.tension_N(row));
            let margin = limit(margin_of_overpull_N(yield_N, part, tension_N));
            let slot = &mut least[component];
            if let Some(margin) = margin
                && slot.is_none_or(|least| margin.capacity < least.capacity)
            {
                *slot = Some(margin.at(Some(component), loads.profile.md_m[row]));
            }
        }
    }
    found.limits.extend(least.into_iter().flatten());
    if let Some(capacity_N) = model.rig.hoist_capacity_N {
        let hangs_N = loads.hook_load_N + model.rig.block_weight_N.unwrap_or(0.0);
        found.limits.extend(limit(capacity_N / factors.hoist - hangs_N));
    }
}
