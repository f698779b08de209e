//! The bit on the rock: a rate law with torque.

use serde::{Deserialize, Serialize};

use super::{
    chain::{Chain, node},
    settings::BitSettings,
};
use crate::operation::{Operation, OperationKind};

/// The bit and the rock front that it cuts.
///
/// The rock front lies where the bit has cut to. Pressed against it with the force `W`, the bit
/// advances it at the rate `v = v₀ (W/W₀)(Ω/Ω₀)`: the operation's rate of penetration at its weight
/// and speed. The bit leaves the rock freely. Its torque is proportional to its weight, `T = T₀ W/W₀`,
/// against the rotation, and holds the bit when the string no longer turns it. A sliding string's
/// bit is turned by its motor: the front advances at the motor's pace and the string carries the
/// reaction.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Bit {
    settings: BitSettings,
    motor: bool,
    on_bottom: bool,
    /// Advance of the front per force and second at nominal speed, m/s/N.
    rate_m_per_s_per_N: f64,
    /// Torque per weight, m.
    torque_per_weight_m: f64,
    nominal_spin_rad_per_s: f64,
    front_m: f64,
}

/// What the bit did in a step.
#[derive(Debug, Clone, Copy, Default)]
pub struct BitStep {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Torque on bit, N·m.
    pub torque_N_m: f64,
    /// Work done on the string, J.
    pub work_J: f64,
}

impl Bit {
    /// The bit of `operation`, pressed with its weight against a front that is `depth_m` deep.
    pub fn new(settings: BitSettings, operation: &Operation, depth_m: f64) -> Self {
        let weight = operation.weight_on_bit_now_N();
        let on_bottom = operation.kind.on_bottom() && weight > 0.0;
        let per = |value: f64| if on_bottom { value / weight } else { 0.0 };
        Self {
            settings,
            motor: operation.kind == OperationKind::Slide,
            on_bottom,
            rate_m_per_s_per_N: per(operation.rate_of_penetration_m_per_s),
            torque_per_weight_m: per(operation.bit_torque_N_m),
            nominal_spin_rad_per_s: operation.rotation_rad_per_s(),
            front_m: depth_m - weight / settings.rock_stiffness_N_per_m,
        }
    }

    /// Corrects the bit's node, which the step has moved without it, and advances the front. The rock
    /// is evaluated at the step's end: with last step's position it would feed energy in. `md_m` is the
    /// depth of the node's anchor; velocity and spin before the step are given for the work done.
    pub fn act(
        &mut self,
        chain: &mut Chain,
        md_m: f64,
        velocity_before: crate::rod::vector::Vector<f64>,
        spin_before: f64,
        dt: f64,
    ) -> BitStep {
        let index = chain.nodes() - 1;
        let tangent = chain.tangent(index);
        let mut velocity = chain.velocity(index);
        let mut displacement = chain.displacement(index);

        // Held to the hole's axis.
        let mobility = dt * node!(chain, index, inv_mass_lateral);
        let across = displacement.minus(tangent, displacement.dot(tangent));
        let k = self.settings.lateral_stiffness_N_per_m;
        let hold = k / (1.0 + k * mobility * dt);
        velocity = velocity.minus(across, mobility * hold);
        displacement = displacement.minus(across, dt * mobility * hold);
        let mut work = -hold * across.dot((velocity_before + velocity).scaled(0.5));

        let mut step = BitStep::default();
        if self.on_bottom {
            // The spin that the step gave without the rock is not the bit's: its torque is to come.
            let pace = if self.motor || self.nominal_spin_rad_per_s == 0.0 {
                1.0
            } else {
                (spin_before / self.nominal_spin_rad_per_s).max(0.0)
            };
            let rate = self.rate_m_per_s_per_N * pace;
            let mobility = dt * node!(chain, index, inv_mass_axial);
            let depth = md_m + displacement.dot(tangent);
            let k = self.settings.rock_stiffness_N_per_m;
            let weight = (k * (depth - self.front_m) / (1.0 + k * dt * (mobility + rate))).max(0.0);
            velocity = velocity.minus(tangent, mobility * weight);
            displacement = displacement.minus(tangent, dt * mobility * weight);
            self.front_m += dt * rate * weight;

            let spin = node!(chain, index, spin);
            let wanted = self.torque_per_weight_m * weight;
            let mobility = dt * node!(chain, index, inv_polar);
            // Rock stops a bit but never turns it back; a motor's reaction does turn the string.
            let torque = if self.motor {
                wanted
            } else {
                wanted.min(spin.max(0.0) / mobility)
            };
            node!(chain, index, spin = spin - mobility * torque);
            work -= weight * tangent.dot((velocity_before + velocity).scaled(0.5))
                + torque * 0.5 * (spin_before + node!(chain, index, spin));
            step = BitStep {
                weight_on_bit_N: weight,
                torque_N_m: torque,
                work_J: 0.0,
            };
        }
        chain.set_velocity(index, velocity);
        chain.set_displacement(index, displacement);
        step.work_J = work * dt;
        step
    }
}
