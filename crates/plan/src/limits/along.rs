//! Limits along the string: of each component the place that is nearest to its limit.

use super::{
    LimitKind, LimitSettings, LoadCheck,
    limit::Limits,
    loads::Loads,
    strengths::{Strength, Strengths},
};
use crate::strength::worst_stress;

/// Adds the limits of the components.
pub fn limits(
    strengths: &Strengths<'_>,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    found: &mut Limits,
) {
    let mut worst = vec![None::<(LoadCheck, usize)>; LimitKind::ALL.len() * strengths.count()];
    for row in 0..loads.rows() {
        for component in loads.components(row) {
            let strength = strengths.component(component);
            at_row(strength, loads, row, component, |kind, load, capacity| {
                let Some(limit) = LoadCheck::new(kind, load, capacity, &settings.factors) else {
                    return;
                };
                let slot = &mut worst[component * LimitKind::ALL.len() + kind as usize];
                if slot.as_ref().is_none_or(|(worst, _)| limit.factor < worst.factor) {
                    let at = limit.at(Some(component), loads.profile.md_m[row]);
                    *slot = Some((at, row));
                }
            });
        }
    }
    for (limit, row) in worst.into_iter().flatten() {
        let stress = (limit.kind == LimitKind::VonMises)
            .then(|| strengths.component(limit.component?).body)
            .flatten()
            .map(|body| worst_stress(body.component(), &loads.body(row)));
        found.limits.push(LoadCheck { stress, ..limit });
    }
}

/// Tells load and capacity of each kind at a row.
fn at_row(
    strength: &Strength<'_>,
    loads: &Loads<'_>,
    row: usize,
    component: usize,
    mut tell: impl FnMut(LimitKind, f64, f64),
) {
    let (tension_N, torque_N_m) = (loads.tension_N(row), loads.torque_N_m(row));
    if let Some(yield_N) = strength.tensile_yield_N() {
        tell(LimitKind::Tension, tension_N, yield_N);
    }
    if let Some(yield_N_m) = strength.torsional_yield_N_m() {
        tell(LimitKind::Torsion, torque_N_m, yield_N_m);
    }
    if let Some(made_up_N_m) = strength.connection.make_up_torque_N_m {
        tell(LimitKind::MakeUp, torque_N_m, made_up_N_m);
    }
    if let Some(body) = &strength.body {
        let bears_N_m = body.torsional_yield_under_N_m(tension_N);
        tell(LimitKind::TensionAndTorsion, torque_N_m, bears_N_m);
    }
    if !loads.bends(row, component) {
        return;
    }
    if let Some(body) = &strength.body {
        let of = loads.body(row);
        let burst_Pa = of.inside_Pa - of.outside_Pa;
        let stress_Pa = loads.largest_von_mises_Pa(row).unwrap_or_else(|| {
            let (section, bent_N_m) = (body.section(), of.bending_N_m);
            section.von_mises_Pa(tension_N, bent_N_m, torque_N_m, burst_Pa * burst_Pa)
        });
        tell(LimitKind::VonMises, stress_Pa, body.yield_strength_Pa());
        tell(LimitKind::Burst, burst_Pa, body.burst_Pa());
        if burst_Pa < 0.0 {
            tell(LimitKind::Collapse, -burst_Pa, body.collapse(tension_N).pressure_Pa);
        }
    }
    let p = loads.profile;
    let critical_N = |column: &[Option<f64>]| column.get(row).copied().flatten();
    let compression_N = -p.tension_N[row];
    if let Some(load_N) = critical_N(&p.sinusoidal_load_N) {
        tell(LimitKind::SinusoidalBuckling, compression_N, load_N);
    }
    if let Some(load_N) = critical_N(&p.helical_load_N) {
        tell(LimitKind::HelicalBuckling, compression_N, load_N);
    }
}
