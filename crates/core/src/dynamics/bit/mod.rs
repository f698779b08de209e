//! The bit on the rock: what every law shares, and the choice of the law.

mod bottom;
mod excitation;
mod rate;
mod regenerative;
mod settings;

use serde::{Deserialize, Serialize};

pub use self::{
    excitation::{Band, Excitation},
    regenerative::{RegenerativeLaw, SteadyCut},
    settings::{BitLaw, BitSettings, RateLaw},
};
use self::{rate::RateCut, regenerative::RegenerativeCut};
use super::chain::{Chain, node};
use crate::rod::number::Real;
use crate::{operation::Operation, rod::vector::Vector};

/// The bit: held to the hole's axis, and on bottom pressed against the rock that it cuts.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Bit {
    lateral_stiffness_N_per_m: f64,
    /// None off bottom.
    cut: Option<Cut>,
}

/// The rock under the bit by one of the laws.
#[derive(Debug, Clone, Serialize, Deserialize)]
enum Cut {
    Rate(RateCut),
    Regenerative(RegenerativeCut),
}

/// The bit's node as the step left it, without the rock.
#[derive(Debug, Clone, Copy)]
struct Approach {
    /// Measured depth of the bit, m.
    depth_m: f64,
    /// Its velocity along the hole, m/s, positive downwards.
    velocity_m_per_s: f64,
    /// Velocity per axial force, s/kg.
    axial_mobility_s_per_kg: f64,
    /// Spin before the step, rad/s.
    spin_before_rad_per_s: f64,
    /// Spin that the step gave, rad/s.
    spin_rad_per_s: f64,
    /// Spin per torque, 1/(N·m·s).
    turning_mobility: f64,
    /// Step, s.
    dt: f64,
}

/// What the rock answers.
#[derive(Debug, Clone, Copy, Default)]
struct Answer {
    weight_N: f64,
    /// Against the string's rotation.
    torque_N_m: f64,
    /// Spin that the torque leaves, exactly zero of a bit that it holds.
    spin_rad_per_s: f64,
    depth_of_cut_m: f64,
}

/// What the bit did in a step.
#[derive(Debug, Clone, Copy, Default)]
pub struct BitStep {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Torque on bit, N·m.
    pub torque_N_m: f64,
    /// Rock that a revolution takes away, m.
    pub depth_of_cut_m: f64,
    /// Work done on the string, J.
    pub work_J: f64,
}

impl Bit {
    /// The bit of `operation` at `depth_m`, pressed on the rock with the operation's weight as it is
    /// while drilling steadily. `seed` is that of the excitation.
    pub fn new(settings: BitSettings, operation: &Operation, depth_m: f64, seed: u64) -> Self {
        let drills = operation.kind.on_bottom() && operation.weight_on_bit_now_N() > 0.0;
        let motor = settings.motor_speed_rad_per_s;
        let cut = drills.then(|| match settings.law {
            BitLaw::Rate(law) => Cut::Rate(RateCut::new(law, motor, operation, depth_m, seed)),
            BitLaw::Regenerative(law) => {
                Cut::Regenerative(RegenerativeCut::new(law, motor, operation, depth_m))
            }
        });
        Self {
            lateral_stiffness_N_per_m: settings.lateral_stiffness_N_per_m,
            cut,
        }
    }

    /// Corrects the bit's node, which the step has moved without it, and advances the rock. The rock
    /// is evaluated at the step's end: with last step's position it would feed energy in. `md_m` is the
    /// depth of the node's anchor; velocity and spin before the step are given for the work done.
    pub fn act(
        &mut self,
        chain: &mut Chain<impl Real>,
        md_m: f64,
        velocity_before: Vector<f64>,
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
        let k = self.lateral_stiffness_N_per_m;
        let hold = k / (1.0 + k * mobility * dt);
        velocity = velocity.minus(across, mobility * hold);
        displacement = displacement.minus(across, dt * mobility * hold);
        let mut work = -hold * across.dot((velocity_before + velocity).scaled(0.5));

        let mut step = BitStep::default();
        if let Some(cut) = &mut self.cut {
            let approach = Approach {
                depth_m: md_m + displacement.dot(tangent),
                velocity_m_per_s: velocity.dot(tangent),
                axial_mobility_s_per_kg: dt * node!(chain, index, inv_mass_axial),
                spin_before_rad_per_s: spin_before,
                spin_rad_per_s: node!(chain, index, spin),
                turning_mobility: dt * node!(chain, index, inv_polar),
                dt,
            };
            let Answer {
                weight_N: weight,
                torque_N_m: torque,
                spin_rad_per_s: spin,
                depth_of_cut_m,
            } = match cut {
                Cut::Rate(cut) => cut.meet(&approach),
                Cut::Regenerative(cut) => cut.meet(&approach),
            };
            let mobility = approach.axial_mobility_s_per_kg;
            velocity = velocity.minus(tangent, mobility * weight);
            displacement = displacement.minus(tangent, dt * mobility * weight);
            node!(chain, index, spin = spin);
            work -= weight * tangent.dot((velocity_before + velocity).scaled(0.5))
                + torque * 0.5 * (spin_before + spin);
            step = BitStep {
                weight_on_bit_N: weight,
                torque_N_m: torque,
                depth_of_cut_m,
                work_J: 0.0,
            };
        }
        chain.set_velocity(index, velocity);
        chain.set_displacement(index, displacement);
        step.work_J = work * dt;
        step
    }
}
