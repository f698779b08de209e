//! Requested overpull against the remaining allowable of each component and of the hoist.

use wholestring::{model::Model, operation::Operation};

use crate::{
    Check, CheckKind, Checks, LimitSettings, loads::Loads, strength::margin_of_overpull_N,
    strengths::Strengths,
};

/// Adds the margins of a string that hangs or is pulled off bottom. For each component this is the
/// least value along it of its tensile yield over the required factor, less its tension; for the
/// hoist likewise, less the hook load and the block.
pub fn limits(
    model: &Model,
    operation: &Operation,
    strengths: &Strengths<'_>,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    checks: &mut Checks,
) {
    if operation.kind.on_bottom() || operation.axial_velocity_m_per_s() > 0.0 {
        return;
    }
    let LimitSettings { factors, overpull_N, .. } = settings;
    let check =
        |margin_N: f64| Check::load(CheckKind::Overpull, *overpull_N, margin_N, factors.overpull);
    let mut least = vec![None::<(f64, usize)>; strengths.count()];
    for row in 0..loads.rows() {
        for component in loads.components(row) {
            let Some(yield_N) = strengths.component(component).tensile_yield_N() else {
                continue;
            };
            let (part, tension_N) = (1.0 / factors.tension, loads.tension_N(row));
            let margin_N = margin_of_overpull_N(yield_N, part, tension_N);
            let slot = &mut least[component];
            if slot.is_none_or(|(least_N, _)| margin_N < least_N) {
                *slot = Some((margin_N, row));
            }
        }
    }
    for (component, found) in model.string.components().iter().zip(least) {
        let Some((margin_N, row)) = found else { continue };
        let place = |check: Check| check.of_component(&component.name).at(loads.profile.md_m[row]);
        checks.checks.extend(check(margin_N).map(place));
    }
    if let Some(capacity_N) = model.rig.hoist_capacity_N {
        let hangs_N = loads.hook_load_N.largest + model.rig.block_weight_N.unwrap_or(0.0);
        checks.checks.extend(check(capacity_N / factors.hoist - hangs_N));
    }
}
