//! An eccentric mass at a node.

use serde::{Deserialize, Serialize};

use super::loads::Loads;
use crate::{
    dynamics::kernel::chain::{Chain, NodeImbalance, node},
    rod::imbalance::{self, Direction, Mobility, Motion},
    simd::{number::Real, vector::Vector},
};

/// A node whose centre of mass is off its axis: see [`imbalance`].
///
/// The chain takes it over for its first step, which does all of this itself. Where something else
/// acts on the node after the step, as the bit and a bend do, it stays here: a part is loads before
/// the step, the rest comes when all else is done.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Imbalance {
    /// The node.
    pub index: usize,
    /// `U`, kg·m.
    pub moment_kg_m: f64,
    /// `U g`, N·m: moment of gravity, which acts straight down, about the axis.
    pub weight_moment_N_m: f64,
    /// `q` at the present position.
    pub toward: Vector<f64>,
    /// `q` half a step before: where the velocities are.
    half: Option<Vector<f64>>,
    /// Before the step: director, velocity.
    before: [Vector<f64>; 2],
    /// `ω × q` that the force before the step has already led to.
    led: Vector<f64>,
}

/// Whole angular velocity of a node, rad/s.
fn whole_turning(chain: &Chain<impl Real>, index: usize) -> Vector<f64> {
    chain.turning(index).plus(chain.director(index), node!(chain, index, spin))
}

/// Kinetic and potential energy that an offset adds to a node at the middle of the last step, J.
pub(super) fn energy_J(chain: &Chain<impl Real>, index: usize, imbalance: &NodeImbalance) -> f64 {
    let q = imbalance.half;
    let turned = whole_turning(chain, index).cross(q);
    imbalance.moment_kg_m * chain.velocity(index).dot(turned) - imbalance.weight_moment_N_m * q.2
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
            before: [Vector::zero(); 2],
            led: Vector::zero(),
        }
    }

    /// As the chain keeps it for the step to come: before the first as if it had turned as now.
    pub(super) fn before_step(&self, chain: &Chain<impl Real>, dt: f64) -> NodeImbalance {
        let omega = whole_turning(chain, self.index);
        let half = || imbalance::half_before(self.toward, omega, dt);
        self.with(self.half.unwrap_or_else(half))
    }

    /// As the last step left it.
    pub(super) fn after_step(&self) -> NodeImbalance {
        self.with(self.half.unwrap_or(self.toward))
    }

    fn with(&self, half: Vector<f64>) -> NodeImbalance {
        let Self { moment_kg_m, weight_moment_N_m, toward, .. } = *self;
        NodeImbalance { moment_kg_m, weight_moment_N_m, toward, half }
    }

    /// Adds the forces of the step to come.
    pub(super) fn push(&mut self, chain: &Chain<impl Real>, dt: f64, loads: &mut Loads) {
        let i = self.index;
        let half = self.before_step(chain, dt).half;
        let omega = whole_turning(chain, i);
        let throw = imbalance::throw(self.toward, half, omega, dt);
        self.before = [chain.director(i), chain.velocity(i)];
        self.led = throw.led;
        // U q × g, gravity straight down.
        let moment = self.toward.cross(Vector(0.0, 0.0, self.weight_moment_N_m));
        loads.add(chain, i, throw.outwards.scaled(self.moment_kg_m), moment);
    }

    /// Runs after the step and everything else: applies the effect of its accelerations and
    /// advances the direction.
    pub(super) fn follow(&mut self, chain: &mut Chain<impl Real>, dt: f64) {
        let i = self.index;
        let motion = Motion {
            director: chain.director(i),
            velocity: chain.velocity(i),
            turning: chain.turning(i),
            spin: node!(chain, i, spin),
        };
        let mobility = Mobility {
            tangent: chain.tangent(i),
            lateral: node!(chain, i, inv_mass_lateral),
            axial: node!(chain, i, inv_mass_axial),
            polar: node!(chain, i, inv_polar),
            rotary: node!(chain, i, inv_rotary),
        };
        let turned =
            imbalance::turned(self.toward, self.before[0], motion.director, motion.spin * dt);
        let change = imbalance::balance(
            self.moment_kg_m,
            &turned,
            self.led,
            self.before[1],
            &motion,
            &mobility,
        );
        let after = imbalance::changed(&motion, &turned, &change, dt);
        chain.set_velocity(i, after.velocity);
        chain.set_displacement(i, chain.displacement(i).minus(change.slowed, dt));
        chain.set_director(i, after.director);
        chain.set_turning(i, after.turning);
        node!(chain, i, spin = after.spin);
        self.half = Some(turned.half);
        let direction = Direction { toward: self.toward, rest: Vector::zero() };
        let carried = imbalance::carried(&direction, &turned, &change, after.director, dt);
        self.toward = carried.toward;
    }
}
