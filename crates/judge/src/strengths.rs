//! Strengths of the components.

use wholestring::{
    model::Model,
    operation::Operation,
    string::{Component, ConnectionStrength},
};

use crate::{
    Check, CheckKind, Checks, LimitSettings, Missing,
    loads::Loads,
    strength::{Body, margin_of_overpull_N},
};

/// Strength of a component.
pub struct Strength<'a> {
    pub connection: ConnectionStrength,
    /// Its body; `None` where the yield strength is not known.
    pub body: Option<Body<'a>>,
}

/// Strengths of the components, from the bit up.
pub struct Strengths<'a>(Vec<Strength<'a>>);

/// Kinds that need the yield strength of the body.
const OF_YIELD: [CheckKind; 6] = [
    CheckKind::Tension,
    CheckKind::Torsion,
    CheckKind::TensionAndTorsion,
    CheckKind::VonMises,
    CheckKind::Burst,
    CheckKind::Collapse,
];

impl<'a> Strength<'a> {
    fn of(component: &'a Component) -> Self {
        Self { connection: component.connection, body: Body::of(component) }
    }
}

impl<'a> Strengths<'a> {
    /// The strengths of a model's string. Missing numbers are added to `checks`, except those of a
    /// bit.
    pub fn of(model: &'a Model, checks: &mut Checks) -> Self {
        let strength = |component: &'a Component| {
            let strength = Strength::of(component);
            if !component.is_bit() {
                let name = Some(component.name.as_str());
                for kind in OF_YIELD {
                    let known = match kind {
                        CheckKind::Tension => strength.tensile_yield_N().is_some(),
                        CheckKind::Torsion => strength.torsional_yield_N_m().is_some(),
                        _ => strength.body.is_some(),
                    };
                    if !known {
                        checks.lacks(kind, name, Missing::YieldStrength);
                    }
                }
                if strength.connection.make_up_torque_N_m.is_none() {
                    checks.lacks(CheckKind::MakeUp, name, Missing::MakeUpTorque);
                }
            }
            strength
        };
        Self(model.string.components().iter().map(strength).collect())
    }

    pub fn component(&self, index: usize) -> &Strength<'a> {
        &self.0[index]
    }

    pub fn count(&self) -> usize {
        self.0.len()
    }
}

impl Strength<'_> {
    /// The tension at which body or connection yields, N.
    pub fn tensile_yield_N(&self) -> Option<f64> {
        let body = self.body.map(|body| body.tensile_yield_N());
        least(body, self.connection.tensile_yield_N)
    }

    /// The torque at which body or connection yields, N·m.
    pub fn torsional_yield_N_m(&self) -> Option<f64> {
        let body = self.body.map(|body| body.torsional_yield_N_m());
        least(body, self.connection.torsional_yield_N_m)
    }
}

/// Torque that a component carries by the limits [`CheckKind::MakeUp`] and [`CheckKind::Torsion`],
/// N·m, without their required factors; `None` where it is not known, and for other limits.
pub fn torque_capacity_N_m(component: &Component, limit: CheckKind) -> Option<f64> {
    match limit {
        CheckKind::MakeUp => component.connection.make_up_torque_N_m,
        CheckKind::Torsion => Strength::of(component).torsional_yield_N_m(),
        _ => None,
    }
}

fn least(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.min(other)),
        (one, other) => one.or(other),
    }
}

// Requested overpull against the remaining allowable of each component and of the hoist.

/// Adds the margins of a string that hangs or is pulled off bottom. For each component this is the
/// least value along it of its tensile yield over the required factor, less its tension; for the
/// hoist likewise, less the hook load and the block.
pub fn overpull_limits(
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

// Side force of the wall on the joints of pipe.

/// Adds the largest side force per joint of each component that has joints.
pub fn side_force_limits(
    model: &Model,
    loads: &Loads<'_>,
    settings: &LimitSettings,
    checks: &mut Checks,
) {
    let kind = CheckKind::SideForce;
    let components = model.string.components();
    let Some(limit_N) = settings.side_force_per_joint_N else {
        if components.iter().any(|component| component.joints.is_some()) {
            checks.lacks(kind, None, Missing::SideForceLimit);
        }
        return;
    };
    let mut largest = vec![None::<(f64, usize)>; components.len()];
    for (row, force_N) in loads.profile.side_force_per_joint_N.iter().enumerate() {
        let Some(force_N) = force_N.map(f64::abs) else { continue };
        let slot = &mut largest[loads.component_above(row)];
        if slot.is_none_or(|(largest_N, _)| force_N > largest_N) {
            *slot = Some((force_N, row));
        }
    }
    for (component, found) in components.iter().zip(largest) {
        let Some((force_N, row)) = found else { continue };
        let check = Check::load(kind, force_N, limit_N, settings.factors.required(kind));
        let place = |check: Check| check.of_component(&component.name).at(loads.profile.md_m[row]);
        checks.checks.extend(check.map(place));
    }
}
