//! What each component bears.

use wholestring::{model::Model, string::BodySection};

use super::{
    limit::{Limits, Missing},
    settings::{ComponentRatings, LimitSettings},
};
use crate::{limits::LimitKind, strength::Body};

/// What a component bears.
pub struct Strength {
    pub ratings: ComponentRatings,
    /// Its body; none where the yield strength is not known.
    pub body: Option<(Body, BodySection)>,
}

/// What the components bear, from the bit up.
pub struct Strengths(Vec<Strength>);

/// Kinds that need the yield strength of the body.
const OF_YIELD: [LimitKind; 6] = [
    LimitKind::Tension,
    LimitKind::Torsion,
    LimitKind::TensionAndTorsion,
    LimitKind::VonMises,
    LimitKind::Burst,
    LimitKind::Collapse,
];

impl Strengths {
    /// Tells what is not known, but of a bit.
    pub fn of(model: &Model, settings: &LimitSettings, found: &mut Limits) -> Self {
        let components = model.string.components().iter().enumerate();
        let strength = |(index, component): (usize, &wholestring::string::Component)| {
            let ratings = settings.components.get(index).copied().unwrap_or_default();
            let body = Body::of(component, ratings.class);
            if !component.is_bit() {
                let of_joints = |kind| match kind {
                    LimitKind::Tension => ratings.joint_tensile_yield_N,
                    LimitKind::Torsion => ratings.joint_torsional_yield_N_m,
                    _ => None,
                };
                for kind in OF_YIELD {
                    if body.is_none() && of_joints(kind).is_none() {
                        found.lacks(kind, Some(index), Missing::YieldStrength);
                    }
                }
                if ratings.make_up_torque_N_m.is_none() {
                    found.lacks(LimitKind::MakeUp, Some(index), Missing::MakeUpTorque);
                }
            }
            let body = body.map(|body| {
                let section = body.section();
                (body, section)
            });
            Strength { ratings, body }
        };
        Self(components.map(strength).collect())
    }

    pub fn component(&self, index: usize) -> &Strength {
        &self.0[index]
    }

    pub fn count(&self) -> usize {
        self.0.len()
    }
}

impl Strength {
    /// The tension at which body or tool joint yields, N.
    pub fn tensile_yield_N(&self) -> Option<f64> {
        let body = self.body.as_ref().map(|(body, _)| body.tensile_yield_N());
        least(body, self.ratings.joint_tensile_yield_N)
    }

    /// The torque at which body or tool joint yields, N·m.
    pub fn torsional_yield_N_m(&self) -> Option<f64> {
        let body = self.body.as_ref().map(|(body, _)| body.torsional_yield_N_m());
        least(body, self.ratings.joint_torsional_yield_N_m)
    }
}

fn least(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.min(other)),
        (one, other) => one.or(other),
    }
}
