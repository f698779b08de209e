//! Strengths of the components.

use wholestring::{
    model::Model,
    string::{Component, ConnectionStrength},
};

use crate::{CheckKind, Checks, Missing, strength::Body};

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
