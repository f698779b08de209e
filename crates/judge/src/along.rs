//! Limits along the string: the place with the least reserve of each component.

use wholestring::model::Model;

use crate::{
    Check, CheckKind, Checks, LimitSettings, Severity, Verdict,
    loads::Loads,
    strength::{CollapseRegime, worst_stress},
    strengths::{Strength, Strengths},
};

/// The place with the least factor of a component by one kind of limit.
#[derive(Debug, Clone, Copy)]
struct Worst {
    kind: CheckKind,
    load: f64,
    capacity: f64,
    row: usize,
}

/// Adds the limits of the components.
pub fn limits(
    model: &Model,
    strengths: &Strengths<'_>,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    checks: &mut Checks,
) {
    let kinds = CheckKind::LIMITS.len();
    let mut worst = vec![None::<Worst>; kinds * strengths.count()];
    let mut beyond_collapse = vec![None::<usize>; strengths.count()];
    for row in 0..loads.rows() {
        for component in loads.components(row) {
            let strength = strengths.component(component);
            let add = |kind: CheckKind, load: f64, capacity: f64| {
                let slot = &mut worst[component * kinds + kind as usize];
                let is_load = load > 0.0 && capacity.is_finite();
                let is_worse = |worst: &Worst| capacity / load < worst.capacity / worst.load;
                if is_load && slot.as_ref().is_none_or(is_worse) {
                    *slot = Some(Worst { kind, load, capacity, row });
                }
            };
            if at_row(strength, loads, row, component, add) == Collapsing::BeyondFormulas {
                let slot = &mut beyond_collapse[component];
                if slot.is_none_or(|other| loads.tension_N(row) > loads.tension_N(other)) {
                    *slot = Some(row);
                }
            }
        }
    }
    let components = model.string.components();
    for (slot, found) in worst.into_iter().enumerate() {
        let Some(Worst { kind, load, capacity, row }) = found else { continue };
        let required = settings.factors.required(kind);
        let Some(check) = Check::load(kind, load, capacity, required) else { continue };
        let component = slot / kinds;
        let stress = (check.kind == CheckKind::VonMises)
            .then(|| strengths.component(component).body)
            .flatten()
            .map(|body| worst_stress(body.component(), &loads.body(row)));
        let name = &components[component].name;
        let check = check.of_component(name).at(loads.profile.md_m[row]);
        checks.checks.push(Check { stress, ..check });
    }
    for (component, row) in beyond_collapse.into_iter().enumerate() {
        let Some(row) = row else { continue };
        let loads_there = loads.body(row);
        let check = Check::reported(CheckKind::Collapse, Severity::Warning)
            .of_component(&components[component].name)
            .at(loads.profile.md_m[row])
            .value(loads_there.outside_Pa - loads_there.inside_Pa);
        checks.checks.push(Check { verdict: Verdict::Warning, ..check });
    }
}

/// Whether the collapse of a body at a row can be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Collapsing {
    Computed,
    BeyondFormulas,
}

/// Gives load and capacity of each kind at a row to `add`.
fn at_row(
    strength: &Strength<'_>,
    loads: &Loads<'_>,
    row: usize,
    component: usize,
    mut add: impl FnMut(CheckKind, f64, f64),
) -> Collapsing {
    let (tension_N, torque_N_m) = (loads.tension_N(row), loads.torque_N_m(row));
    if let Some(yield_N) = strength.tensile_yield_N() {
        add(CheckKind::Tension, tension_N, yield_N);
    }
    if let Some(yield_N_m) = strength.torsional_yield_N_m() {
        add(CheckKind::Torsion, torque_N_m, yield_N_m);
    }
    if let Some(made_up_N_m) = strength.connection.make_up_torque_N_m {
        add(CheckKind::MakeUp, torque_N_m, made_up_N_m);
    }
    if let Some(body) = &strength.body {
        let capacity_N_m = body.torsional_yield_under_N_m(tension_N);
        add(CheckKind::TensionAndTorsion, torque_N_m, capacity_N_m);
    }
    let mut collapsing = Collapsing::Computed;
    if let (Some(body), true) = (&strength.body, loads.bends(row, component)) {
        let body_loads = loads.body(row);
        let burst_Pa = body_loads.inside_Pa - body_loads.outside_Pa;
        let stress_Pa = loads.largest_von_mises_Pa(row).unwrap_or_else(|| {
            let (section, bent_N_m) = (body.section(), body_loads.bending_N_m);
            section.von_mises_Pa(tension_N, bent_N_m, torque_N_m, burst_Pa * burst_Pa)
        });
        add(CheckKind::VonMises, stress_Pa, body.yield_strength_Pa());
        add(CheckKind::Burst, burst_Pa, body.burst_Pa());
        if burst_Pa < 0.0 {
            let collapse = body.collapse(tension_N);
            match collapse.regime {
                CollapseRegime::BeyondFormulas => collapsing = Collapsing::BeyondFormulas,
                _ => add(CheckKind::Collapse, -burst_Pa, collapse.pressure_Pa),
            }
        }
    }
    collapsing
}
