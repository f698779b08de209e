//! An eccentric mass at a node.

use serde::{Deserialize, Serialize};

use super::loads::Loads;
use crate::{
    dynamics::kernel::chain::{Chain, node},
    rod::bent::carried,
    simd::{number::Real, vector::Vector},
};

/// Passes in which momentum and moment of momentum agree. Each leaves the square of the offset over
/// the radius of gyration, a twentieth at most, of what was left before.
const PASSES: usize = 8;

/// A node whose centre of mass lies off its axis.
///
/// With the imbalance `U = Σ m e` (kg·m) in the direction `q`, fixed in the body and across the
/// director, and the angular velocity `ω = w + s d`,
///
/// ```text
/// M v' + U (ω × q)' = F            the centre of mass is thrown outwards
/// I ω' + U q × v'   = m + U q × g  a sideways acceleration turns the pipe, and gravity does
/// ```
///
/// What follows from the turning of `q` at the present `ω` comes before the step, so that the wall
/// feels it like weight; what the step changes in `ω` and `v` comes after it. Theory:
/// `docs/src/theory/bends.md`.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Imbalance {
    /// The node.
    pub index: usize,
    /// `U`, kg·m.
    pub moment_kg_m: f64,
    /// `U g`, N·m: what gravity, straight down, has as its lever.
    pub weight_moment_N_m: f64,
    /// `q` at the present position.
    pub toward: Vector<f64>,
    /// `q` half a step before: where the velocities are.
    half: Option<Vector<f64>>,
    /// Before the step: director, velocity, angular velocity.
    before: [Vector<f64>; 3],
    /// `ω × q` that the force before the step has already led to.
    led: Vector<f64>,
}

fn unit(v: Vector<f64>) -> Vector<f64> {
    v.scaled(1.0 / v.dot(v).sqrt())
}

/// Whole angular velocity of a node, rad/s.
fn whole_turning(chain: &Chain<impl Real>, index: usize) -> Vector<f64> {
    chain.turning(index).plus(chain.director(index), node!(chain, index, spin))
}

impl Imbalance {
    /// An imbalance of `moment_kg_m` towards the unit vector `toward`.
    pub fn new(index: usize, moment_kg_m: f64, gravity_m_per_s2: f64, toward: Vector<f64>) -> Self {
        Self {
            index,
            moment_kg_m,
            weight_moment_N_m: moment_kg_m * gravity_m_per_s2,
            toward,
            half: None,
            before: [Vector::zero(); 3],
            led: Vector::zero(),
        }
    }

    /// Adds the forces of the step to come.
    pub(in crate::dynamics) fn push(
        &mut self,
        chain: &Chain<impl Real>,
        dt: f64,
        loads: &mut Loads,
    ) {
        let i = self.index;
        let omega = whole_turning(chain, i);
        let q = self.toward;
        self.before = [chain.director(i), chain.velocity(i), omega];
        // −U Δ(ω × q)/dt between the middles of the last step and of this one.
        let ahead = unit(q.plus(omega.cross(q), 0.5 * dt));
        let behind = self.half.unwrap_or_else(|| unit(q.minus(omega.cross(q), 0.5 * dt)));
        self.led = omega.cross(ahead);
        let outwards = (self.led - omega.cross(behind)).scaled(-self.moment_kg_m / dt);
        // U q × g, gravity straight down.
        let moment = q.cross(Vector(0.0, 0.0, self.weight_moment_N_m));
        loads.add(chain, i, outwards, moment);
    }

    /// After the step: what its accelerations add, and the direction carried on.
    pub(in crate::dynamics) fn follow(&mut self, chain: &mut Chain<impl Real>, dt: f64) {
        let i = self.index;
        let [director, v_before, _] = self.before;
        let (v_step, spin_step) = (chain.velocity(i), node!(chain, i, spin));
        let (d, w_step) = (chain.director(i), chain.turning(i));
        let q = self.toward;
        let half = unit(q + carried(q, director, d, spin_step * dt));
        let tangent = chain.tangent(i);
        let lateral = node!(chain, i, inv_mass_lateral);
        let axial = node!(chain, i, inv_mass_axial);
        let (polar, rotary) = (node!(chain, i, inv_polar), node!(chain, i, inv_rotary));
        // Velocity of an impulse: less mass moves along the hole than across it.
        let moved = |impulse: Vector<f64>| {
            let along = impulse.dot(tangent);
            impulse.minus(tangent, along).scaled(lateral).plus(tangent, along * axial)
        };
        let (mut dv, mut dw, mut ds) = (Vector::zero(), Vector::zero(), 0.0);
        for _ in 0..PASSES {
            // M dv = −U (ω × q − led), I dω = −U q × Δv: each with the other's last value.
            let omega = (w_step + dw).plus(d, spin_step + ds);
            dv = moved((omega.cross(half) - self.led).scaled(-self.moment_kg_m));
            let moment = q.cross(v_step + dv - v_before).scaled(-self.moment_kg_m);
            let about = moment.dot(d);
            ds = about * polar;
            dw = moment.minus(d, about).scaled(rotary);
        }
        // The step has turned the director by its own w: the rest follows.
        let d_moved = unit(d.plus(dw.cross(d), dt));
        let w = w_step + dw;
        chain.set_velocity(i, v_step + dv);
        chain.set_displacement(i, chain.displacement(i).plus(dv, dt));
        chain.set_director(i, d_moved);
        chain.set_turning(i, w.minus(d_moved, w.dot(d_moved)));
        node!(chain, i, spin += ds);
        self.half = Some(half);
        self.toward = carried(q, director, d_moved, (spin_step + ds) * dt);
    }

    /// `q` where the velocities are: half a step before the positions.
    pub fn halfway(&self) -> Vector<f64> {
        self.half.unwrap_or(self.toward)
    }

    /// Kinetic and potential energy that the offset adds at the middle of the last step, J.
    pub(in crate::dynamics) fn energy_J(&self, chain: &Chain<impl Real>) -> f64 {
        let q = self.halfway();
        let turned = whole_turning(chain, self.index).cross(q);
        self.moment_kg_m * chain.velocity(self.index).dot(turned) - self.weight_moment_N_m * q.2
    }
}
