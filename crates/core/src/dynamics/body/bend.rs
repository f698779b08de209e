//! A bend of the body, and the element below it.

use serde::{Deserialize, Serialize};

use super::loads::Loads;
use crate::{
    dynamics::kernel::{
        chain::{Chain, element, node},
        half_step::half_a_step_before,
        step::StepInput,
    },
    rod::{
        bent::{carried, director_below, moment_above, moment_below, pose_below},
        element::{Pose, energy, react},
    },
    simd::{number::Real, vector::Vector},
};

/// A bend at a node: the element below it, of the same number, is tilted against the node's
/// director.
///
/// The step evaluates that element as if there were no bend. The bend's changes of forces and
/// moments are applied before the step, from the same positions, velocities and twist; those of
/// tension, torque and twist after it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Bend {
    /// The node, and the element below it.
    pub index: usize,
    /// Its angle when all of it is there, rad.
    pub angle_rad: f64,
    /// Its direction, fixed in the body: across the director.
    pub toward: Vector<f64>,
    /// Part of the angle that is there: it grows while the string is initialised.
    part: f64,
    /// Director before the step.
    director: Vector<f64>,
    /// Tension, torque and twist of the element as they are with the bend.
    element: [f64; 3],
}

/// Effect of a bend on the energy of the string in a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct BendStep {
    /// Work of growing.
    pub work_J: f64,
    /// Energy lost to stiffness-proportional damping in excess of the loss without the bend, J.
    pub loss_J: f64,
}

impl Bend {
    /// A bend at node `index` that has not grown yet.
    pub fn new(index: usize, angle_rad: f64, toward: Vector<f64>) -> Self {
        Self { index, angle_rad, toward, part: 0.0, director: Vector::zero(), element: [0.0; 3] }
    }

    /// The pose of the element below, as the bend shows it.
    pub fn pose(&self, chain: &Chain<impl Real>) -> Pose<f64> {
        self.pose_with(chain, self.part)
    }

    fn below(&self, chain: &Chain<impl Real>, part: f64) -> Vector<f64> {
        director_below(chain.director(self.index), self.toward, part * self.angle_rad)
    }

    fn pose_with(&self, chain: &Chain<impl Real>, part: f64) -> Pose<f64> {
        let below = self.below(chain, part);
        pose_below(&chain.pose(self.index), node!(chain, self.index, spin), below)
    }

    /// Adds the bend's changes to the forces of the coming step, where `part` is the present
    /// fraction of its angle.
    pub(in crate::dynamics) fn push(
        &mut self,
        chain: &Chain<impl Real>,
        input: &StepInput,
        part: f64,
        loads: &mut Loads,
    ) -> BendStep {
        let (upper, lower) = (self.index, self.index + 1);
        let k = chain.stiffness(upper);
        let mut step = BendStep::default();
        if part != self.part {
            // Bending the body in place, nothing moving, changes the elastic energy alone.
            step.work_J = energy(&k, &self.pose_with(chain, part)) - energy(&k, &self.pose(chain));
            self.part = part;
        }
        self.director = chain.director(upper);
        let (mut pose, straight_pose) = (self.pose(chain), chain.pose(upper));
        // The twist is carried on with the directors of half a step ago, where its rate is: with
        // those of now, two ends that turn about different axes would gain energy of first order in
        // the step.
        let halfway = Pose { twist: pose.twist, ..half_a_step_before(pose, input.dt) };
        pose.twist = react(&k, &halfway, input.dt, 0.0).twist;
        let bent = react(&k, &pose, 0.0, input.stiffness_damping);
        // The reaction that the step itself computes, without the bend.
        let straight = react(&k, &straight_pose, input.dt, input.stiffness_damping);
        let force = bent.force - straight.force;
        let above = moment_above(&bent, pose.d1) - moment_above(&straight, straight_pose.d1);
        let below = moment_below(&bent, pose.d2) - moment_below(&straight, pose.d2);
        loads.add(chain, upper, -force, above);
        loads.add(chain, lower, force, below);
        self.element = [bent.tension, bent.torque, bent.twist];
        step.loss_J = (bent.damping_power - straight.damping_power) * input.dt;
        step
    }

    /// After the step: the element's records, and the bend's direction carried on.
    pub(in crate::dynamics) fn follow(&mut self, chain: &mut Chain<impl Real>, dt: f64) {
        let [tension, torque, twist] = self.element;
        element!(chain, self.index, tension = tension);
        element!(chain, self.index, torque = torque);
        element!(chain, self.index, twist = twist);
        let turn = node!(chain, self.index, spin) * dt;
        self.toward = carried(self.toward, self.director, chain.director(self.index), turn);
    }

    /// Elastic energy that the bend adds to that of the chain at the middle of the last step, J.
    pub(in crate::dynamics) fn energy_J(&self, chain: &Chain<impl Real>, dt: f64) -> f64 {
        let k = chain.stiffness(self.index);
        let before = |pose| energy(&k, &half_a_step_before(pose, dt));
        before(self.pose(chain)) - before(chain.pose(self.index))
    }
}
