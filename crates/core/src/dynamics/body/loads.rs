//! Forces and moments on single nodes in addition to those of the step.

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::kernel::{
        chain::{Chain, element, node},
        step::StepInput,
    },
    rod,
    simd::{number::Real, vector::Vector},
};

/// Forces and moments on single nodes in addition to those of the step, all evaluated at the
/// positions before it.
///
/// A force is added to the node's weight for one step, so that the step itself distributes it among
/// wall, friction and motion and accounts for its losses correctly. A moment about the director is
/// an increment of the spin before the step, so that friction can cancel it within the step. A
/// moment across the director is an increment after the step, because the moments of bends are
/// large and would appear as rotation in the twist and the damping of the neighbours. The increment
/// of the spin would do the same, so its effect on twist, damping, mud and friction is subtracted
/// again and nothing is lost in a string at rest.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Loads {
    pub(super) loads: Vec<Load>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Load {
    index: usize,
    force: Vector<f64>,
    moment: Vector<f64>,
    /// Before the step: the node's weight, its director, its sum of friction torque, and its spin.
    weight: Vector<f64>,
    director: Vector<f64>,
    friction: f64,
    spin: f64,
    /// The spin that it is given, rad/s, and the part of its spin that the mud takes in the step.
    spun: f64,
    slowed: f64,
}

/// Most that viscous mud takes of a node's spin in a step: as in the step itself.
const MAX_SLOWED: f64 = 0.5;

/// Power that stiffness-proportional damping takes of the elements at a node as they move now, W.
fn damped_W(chain: &Chain<impl Real>, index: usize, beta: f64) -> f64 {
    let elements = index.saturating_sub(1)..(index + 1).min(chain.elements());
    elements
        .map(|e| rod::element::twist(&chain.stiffness(e), &chain.pose(e), 0.0, beta).damping_power)
        .sum()
}

/// Turns a node by an angle in the twist of the elements at it, rad.
fn twist_neighbours(chain: &mut Chain<impl Real>, index: usize, angle: f64) {
    if index > 0 {
        element!(chain, index - 1, twist += angle);
    }
    if index < chain.elements() {
        element!(chain, index, twist -= angle);
    }
}

impl Loads {
    /// Adds a force (N) and a moment (N·m) on a node.
    pub(in crate::dynamics) fn add(
        &mut self,
        chain: &Chain<impl Real>,
        index: usize,
        force: Vector<f64>,
        moment: Vector<f64>,
    ) {
        self.loads.push(Load {
            index,
            force,
            moment,
            weight: Vector::zero(),
            director: chain.director(index),
            friction: 0.0,
            spin: 0.0,
            spun: 0.0,
            slowed: 0.0,
        });
    }

    /// Loads the nodes. Returns the energy that the step will book in excess to
    /// stiffness-proportional damping, J.
    pub(in crate::dynamics) fn apply(
        &mut self,
        chain: &mut Chain<impl Real>,
        input: &StepInput,
    ) -> f64 {
        let (dt, beta) = (input.dt, input.stiffness_damping);
        let mut excess_W = 0.0;
        for load in &mut self.loads {
            let index = load.index;
            load.weight = chain.weight(index);
            chain.set_weight(index, load.weight + load.force);
            let mobility = dt * node!(chain, index, inv_polar);
            load.slowed = (mobility * node!(chain, index, mud_spin)).min(MAX_SLOWED);
            // The mud takes its part of the node's own spin, but must leave the added spin whole.
            load.spun = mobility * load.moment.dot(load.director) / (1.0 - load.slowed);
            load.friction = node!(chain, index, sum_torque);
            load.spin = node!(chain, index, spin);
            let lost_W = |chain: &_| damped_W(chain, index, beta);
            excess_W -= lost_W(chain);
            node!(chain, index, spin += load.spun);
            excess_W += lost_W(chain);
            // The step carries the twist on by the spin that it finds, and damps it: by that of
            // half a step ago, without this kick.
            twist_neighbours(chain, index, -(dt + beta) * load.spun);
        }
        excess_W * dt
    }

    /// Restores the weights, turns the directors by the moments across them and removes from the
    /// step's sums the excess booked to friction. Returns the excess booked to the mud, J, which
    /// took the increments for spin that the nodes had before.
    pub(in crate::dynamics) fn finish(
        &mut self,
        chain: &mut Chain<impl Real>,
        input: &StepInput,
    ) -> f64 {
        let (dt, beta) = (input.dt, input.stiffness_damping);
        let mut excess = 0.0;
        // The last first: a node may have been taken twice.
        for load in self.loads.drain(..).rev() {
            let index = load.index;
            chain.set_weight(index, load.weight);
            twist_neighbours(chain, index, beta * load.spun);
            let rubbed = node!(chain, index, sum_torque) - load.friction;
            node!(chain, index, sum_wear -= 0.5 * dt * rubbed * load.spun);
            let both = 2.0 * load.spin + load.spun + node!(chain, index, spin);
            excess += 0.5 * node!(chain, index, polar) * load.slowed * load.spun * both;

            // Half of a kick precesses, half does not; then the director turns anew by all of it,
            // as in the step.
            let d = load.director;
            let across = load.moment.minus(d, load.moment.dot(d));
            let kick = across.scaled(0.5 * dt * node!(chain, index, inv_rotary));
            let p = 0.5 * dt * node!(chain, index, gyroscopic) * node!(chain, index, spin);
            let (sine, cosine) = libm::sincos(2.0 * libm::atan(p));
            let w = chain.turning(index) + kick + kick.scaled(cosine).minus(kick.cross(d), sine);
            let q = 0.25 * dt * dt * w.dot(w);
            let turned = d.scaled((1.0 - q) / (1.0 + q)).plus(w.cross(d), dt / (1.0 + q));
            chain.set_turning(index, w);
            chain.set_director(index, turned);
        }
        excess
    }
}
