//! Estimate of the string's state at time zero from the soft string.

use nalgebra::Vector3;

use super::scene::Scene;
use crate::{
    dynamics::settings::{DynamicsSettings, FrictionLaw, Start},
    model::Model,
    operation::Operation,
    statics::soft::{self, SoftError, SoftSettings},
};

/// Side force at which the string is placed halfway to the wall, N/m: where less presses it
/// there, it hangs nearer to the axis.
const LIGHT_N_PER_M: f64 = 10.0;

/// Soft-string estimate for every element and node.
pub(super) struct Guide {
    /// Tension of each element, N.
    pub(super) tension_N: Vec<f64>,
    /// Torque of each element, N·m.
    pub(super) torque_N_m: Vec<f64>,
    /// Offset of each node from the axis as a part of its clearance.
    pub(super) lean: Vec<Vector3<f64>>,
}

impl Guide {
    pub(super) fn new(scene: &Scene<'_>) -> Result<Self, SoftError> {
        let Scene { settings, mesh, viscous, .. } = *scene;
        let (model, operation) = as_soft_string(scene);
        let profile = soft::solve(&model, &operation, &SoftSettings::default())?;
        let depth = |from_bit_m: f64| operation.bit_depth_m - from_bit_m;
        let middle = |i: usize| depth(mesh.nodes[i].from_bit_m - 0.5 * mesh.elements[i].length_m);
        let tension_N = (0..mesh.elements.len())
            .map(|i| if settings.starts_cold() { 0.0 } else { profile.tension_at_N(middle(i)) })
            .collect();
        let turning = settings.start == Start::Prepared && operation_turns(&operation, settings);
        // Torque from the bit up: the friction torque of each node is added.
        let mut torque_N_m = vec![0.0; mesh.elements.len()];
        let mut torque = operation.bit_torque_now_N_m();
        let mut lean = vec![Vector3::zeros(); mesh.nodes.len()];
        for i in (0..mesh.nodes.len()).rev() {
            let md = depth(mesh.nodes[i].from_bit_m);
            let load = profile.side_force_at_N_per_m(md).abs();
            let side = profile.contact_direction_at(md);
            let friction = model.well.hole.at(md).friction;
            let friction = friction.kinetic * friction.around;
            // Wherever the nodes are, the component touches with its joints.
            let radius = model.string.component_at(mesh.nodes[i].from_bit_m).1.contact_radius_m();
            let mu = if turning {
                around(friction, radius, &operation, settings.friction_law)
            } else {
                0.0
            };
            // A turning pipe climbs the wall until friction carries it: atan(mu) from the load.
            let climb = 1.0 / (1.0 + mu * mu).sqrt();
            let tangent = model.well.path.at(md).tangent;
            // The contact's direction turned about the hole by the angle of the climb.
            let touch = climb * side - mu * climb * tangent.cross(&side);
            lean[i] = touch * (load / (load + LIGHT_N_PER_M));
            if i > 0 {
                let length = mesh.tributary_length_m(i);
                // Friction torque of a climbed pipe, μ q ℓ r/√(1 + μ²).
                torque += mu * climb * load * length * radius;
                let mud = viscous.map_or(0.0, |mud| mud.torque_N_m(i - 1));
                // An element's torque is that at its middle: half of the torque of its mud acts
                // below.
                torque_N_m[i - 1] = torque + 0.5 * mud;
                torque += mud;
            }
        }
        Ok(Self { tension_N, torque_N_m, lean })
    }
}

fn operation_turns(operation: &Operation, settings: &DynamicsSettings) -> bool {
    // The guide of the independent law is solved as a sliding string but turns all the same.
    operation.rotary_speed_rad_per_s > 0.0
        && (operation.kind.rotates() || settings.friction_law == FrictionLaw::Independent)
}

/// The soft string whose tension the start takes: without friction for a centred start and for a
/// string at rest, as if it had been turned before; with the full axial friction of a sliding
/// string for the independent law.
fn as_soft_string(scene: &Scene<'_>) -> (Model, Operation) {
    let Scene { settings, at_rest, .. } = *scene;
    let (mut model, mut operation) = (scene.model.clone(), *scene.operation);
    if !operation.kind.rotates() {
        operation.rotary_speed_rad_per_s = 0.0;
    }
    if settings.start == Start::Centred || at_rest {
        // Zero is a coefficient that every hole takes.
        if let Ok(frictionless) = model.well.hole.with_friction(0.0) {
            model.well.hole = frictionless;
        }
    } else if settings.friction_law == FrictionLaw::Independent {
        operation.kind = operation.kind.without_rotation();
    }
    (model, operation)
}

/// The part that acts around the hole, of the friction coefficient around it.
fn around(mu: f64, radius_m: f64, operation: &Operation, law: FrictionLaw) -> f64 {
    match law {
        FrictionLaw::Independent => mu,
        FrictionLaw::Vector => {
            let surface = radius_m * operation.rotary_speed_rad_per_s;
            mu * surface / libm::hypot(surface, operation.axial_velocity_m_per_s())
        }
    }
}

#[cfg(test)]
mod tests;
