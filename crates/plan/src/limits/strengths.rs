//! What each component bears.

use wholestring::{
    model::Model,
    string::{Component, ConnectionStrength},
};

use super::{
    kind::LimitKind,
    limit::{Limits, Missing},
};
use crate::strength::Body;

/// What a component bears.
pub struct Strength<'a> {
    pub connection: ConnectionStrength,
    /// Its body; none where the yield strength is not known.
    pub body: Option<Body<'a>>,
}

/// What the components bear, from the bit up.
pub struct Strengths<'a>(Vec<Strength<'a>>);

/// Kinds that need the yield strength of the body.
const OF_YIELD: [LimitKind; 6] = [
    LimitKind::Tension,
    LimitKind::Torsion,
    LimitKind::TensionAndTorsion,
    LimitKind::VonMises,
    LimitKind::Burst,
    LimitKind::Collapse,
];

impl<'a> Strengths<'a> {
    /// Tells what is not known, but of a bit.
    pub fn of(model: &'a Model, found: &mut Limits) -> Self {
        let components = model.string.components().iter().enumerate();
        let strength = |(index, component): (usize, &'a Component)| {
            let strength = Strength { connection: component.connection, body: Body::of(component) };
            if !component.is_bit() {
                for kind in OF_YIELD {
                    let known = match kind {
                        LimitKind::Tension => strength.tensile_yield_N().is_some(),
                        LimitKind::Torsion => strength.torsional_yield_N_m().is_some(),
                        _ => strength.body.is_some(),
                    };
                    if !known {
                        found.lacks(kind, Some(index), Missing::YieldStrength);
                    }
                }
                if strength.connection.make_up_torque_N_m.is_none() {
                    found.lacks(LimitKind::MakeUp, Some(index), Missing::MakeUpTorque);
                }
            }
            strength
        };
        Self(components.map(strength).collect())
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

fn least(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.min(other)),
        (one, other) => one.or(other),
    }
}
