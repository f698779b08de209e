//! What is fixed in the body of the string and turns with it: bends and eccentric masses.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::{
    assembly::Anchor,
    bent::Bend,
    chain::{Chain, element, node},
    imbalance::Imbalance,
    step::StepInput,
};
use crate::damage::{Damaged, sound};
use crate::{
    GRAVITY_M_PER_S2,
    model::Model,
    rod::{bent::transported, element::Pose, mesh::Mesh, number::Real, vector::Vector},
};

/// Forces and moments on single nodes beside those of the step, all at the positions before it.
///
/// A force is added to the node's weight for one step, so that the step itself shares it out between wall,
/// friction and motion and books its losses right. A moment about the director is a kick of the spin before the step, so
/// that friction can take it back within it; one across the director a kick after it, for the moments of bends are
/// large and would show as turning in the twist and the damping of the neighbours.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Loads {
    loads: Vec<Load>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Load {
    index: usize,
    force: Vector<f64>,
    moment: Vector<f64>,
    /// Before the step: the node's weight, its director, its sum of friction torque, and the spin that it was given.
    weight: Vector<f64>,
    director: Vector<f64>,
    friction: f64,
    spun: f64,
}

impl Loads {
    /// Adds a force (N) and a moment (N·m) on a node.
    pub(super) fn add(
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
            spun: 0.0,
        });
    }

    fn apply(&mut self, chain: &mut Chain<impl Real>, dt: f64) {
        for load in &mut self.loads {
            let index = load.index;
            load.weight = chain.weight(index);
            chain.set_weight(index, load.weight + load.force);
            load.spun = dt * node!(chain, index, inv_polar) * load.moment.dot(load.director);
            load.friction = node!(chain, index, sum_torque);
            node!(chain, index, spin += load.spun);
            // The step carries the twist on by the spin that it finds: that of half a step ago, without this kick.
            if index > 0 {
                element!(chain, index - 1, twist -= dt * load.spun);
            }
            if index < chain.elements() {
                element!(chain, index, twist += dt * load.spun);
            }
        }
    }

    /// Gives the weights back and turns the directors by the moments across them. What the step booked too much to
    /// friction, J: it took the kicks for spin that the nodes had before.
    fn finish(&mut self, chain: &mut Chain<impl Real>, dt: f64) -> f64 {
        let mut excess = 0.0;
        // The last first: a node may have been taken twice.
        for load in self.loads.drain(..).rev() {
            let index = load.index;
            chain.set_weight(index, load.weight);
            excess += 0.5 * dt * (node!(chain, index, sum_torque) - load.friction) * load.spun;

            // Half of a kick precesses, half does not; then the director turns anew by all of it, as in the step.
            let d = load.director;
            let across = load.moment.minus(d, load.moment.dot(d));
            let kick = across.scaled(0.5 * dt * node!(chain, index, inv_rotary));
            let p = 0.5 * dt * node!(chain, index, gyroscopic) * node!(chain, index, spin);
            let (sine, cosine) = (2.0 * p.atan()).sin_cos();
            let w = chain.turning(index) + kick + kick.scaled(cosine).minus(kick.cross(d), sine);
            let q = 0.25 * dt * dt * w.dot(w);
            let turned = d
                .scaled((1.0 - q) / (1.0 + q))
                .plus(w.cross(d), dt / (1.0 + q));
            chain.set_turning(index, w);
            chain.set_director(index, turned);
        }
        excess
    }
}

/// Work and loss of a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct BodyStep {
    /// Work put into the string.
    pub work_J: f64,
    /// Energy that left it.
    pub loss_J: f64,
}

/// The bends and the eccentric masses of a string.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Body {
    /// From the top down, at most one at a node.
    pub bends: Vec<Bend>,
    /// From the top down, at most one at a node.
    pub imbalances: Vec<Imbalance>,
    loads: Loads,
}

impl Body {
    /// Whether stored bends and masses stand where those of the model do.
    pub(super) fn check(&self, fresh: &Self) -> Result<(), Damaged> {
        let bends = |of: &Self| of.bends.iter().map(|bend| bend.index).collect::<Vec<_>>();
        let masses = |of: &Self| {
            of.imbalances
                .iter()
                .map(|one| one.index)
                .collect::<Vec<_>>()
        };
        // Loads are of one step: they are made anew in the next.
        let fits = bends(self) == bends(fresh)
            && masses(self) == masses(fresh)
            && self.loads.loads.is_empty();
        sound(fits, "the bends and eccentric masses")
    }

    /// Bends and eccentric masses of `model` on the nodes of `mesh`. Their directions are set by [`Self::orient`]: until
    /// then `toward` holds the part towards the high side and the part to the right of it.
    pub fn new(model: &Model, mesh: &Mesh) -> Self {
        let (mut bends, mut levers) = (Vec::<Bend>::new(), vec![[0.0; 2]; mesh.nodes.len()]);
        for span in model.string.spans() {
            if let Some(bend) = span.component.bend {
                let index = mesh.nearest_inner_node(span.from_bit_m + bend.from_lower_end_m);
                let (sine, cosine) = bend.toolface_rad.sin_cos();
                bends.push(Bend::new(index, bend.angle_rad, Vector(cosine, sine, 0.0)));
            }
            if let Some(eccentricity) = span.component.eccentricity {
                let moment = span.component.mass_per_length_kg_per_m
                    * eccentricity
                        .effective_offset_m(model.mud.density_kg_per_m3, &span.component.material);
                share_out(mesh, [span.from_bit_m, span.to_bit_m], |node, metres| {
                    let lever = moment * metres;
                    let (sine, cosine) = eccentricity.phase_rad.sin_cos();
                    levers[node][0] += lever * cosine;
                    levers[node][1] += lever * sine;
                });
            }
        }
        bends.sort_by_key(|bend| bend.index);
        let imbalances = levers
            .iter()
            .enumerate()
            // The top is clamped to its axis and turned by the top drive.
            .skip(1)
            .filter(|(_, [x, y])| x.hypot(*y) > 0.0)
            .map(|(index, [x, y])| {
                let size = x.hypot(*y);
                let toward = Vector(x / size, y / size, 0.0);
                Imbalance::new(index, size, GRAVITY_M_PER_S2, toward)
            })
            .collect();
        Self {
            bends,
            imbalances,
            loads: Loads::default(),
        }
    }

    /// Whether there is nothing to do.
    pub fn is_empty(&self) -> bool {
        self.bends.is_empty() && self.imbalances.is_empty()
    }

    /// Turns everything to its angle from the high side at the bit, clockwise as one looks down the hole, carried up
    /// the string without twisting.
    pub fn orient(&mut self, chain: &Chain<impl Real>, anchors: &[Anchor]) {
        if self.is_empty() {
            return;
        }
        let last = chain.nodes() - 1;
        let mut high = Vector::from(anchors[last].high_side);
        let mut before = Vector::from(Vector3::from(chain.tangent(last)));
        let marks = (0..=last).rev().map(|i| {
            let d = chain.director(i);
            high = transported(high, before, d);
            before = d;
            (i, d, high)
        });
        for (i, d, high) in marks {
            let right = d.cross(high);
            let direction = |part: Vector<f64>| {
                let v = high.scaled(part.0).plus(right, part.1);
                let across = v.minus(d, v.dot(d));
                across.scaled(1.0 / across.dot(across).sqrt())
            };
            for bend in self.bends.iter_mut().filter(|bend| bend.index == i) {
                bend.toward = direction(bend.toward);
            }
            for imbalance in self.imbalances.iter_mut().filter(|x| x.index == i) {
                imbalance.toward = direction(imbalance.toward);
            }
        }
    }

    /// The pose of an element, as a bend at its upper node shows it if there is one.
    pub fn pose(&self, chain: &Chain<impl Real>, index: usize) -> Pose<f64> {
        match self.bends.iter().find(|bend| bend.index == index) {
            Some(bend) => bend.pose(chain),
            None => chain.pose(index),
        }
    }

    /// Acts before the step: `bent_part` of each bend is there.
    pub fn push(
        &mut self,
        chain: &mut Chain<impl Real>,
        input: &StepInput,
        bent_part: f64,
    ) -> BodyStep {
        let mut sum = BodyStep::default();
        if self.is_empty() {
            return sum;
        }
        for bend in &mut self.bends {
            let step = bend.push(chain, input, bent_part, &mut self.loads);
            sum.work_J += step.work_J;
            sum.loss_J += step.loss_J;
        }
        for imbalance in &mut self.imbalances {
            imbalance.push(chain, input.dt, &mut self.loads);
        }
        self.loads.apply(chain, input.dt);
        sum
    }

    /// Acts after the step and whatever else moves nodes in it.
    pub fn follow(&mut self, chain: &mut Chain<impl Real>, dt: f64) -> BodyStep {
        let mut sum = BodyStep::default();
        if self.is_empty() {
            return sum;
        }
        sum.loss_J -= self.loads.finish(chain, dt);
        for imbalance in &mut self.imbalances {
            imbalance.follow(chain, dt);
        }
        for bend in &mut self.bends {
            bend.follow(chain, dt);
        }
        sum
    }

    /// Elastic energy of the bends at the middle of the last step, J.
    pub fn bends_J(&self, chain: &Chain<impl Real>, dt: f64) -> f64 {
        self.bends.iter().map(|b| b.energy_J(chain, dt)).sum()
    }

    /// Energy that eccentric masses add at the middle of the last step, J.
    pub fn imbalances_J(&self, chain: &Chain<impl Real>) -> f64 {
        self.imbalances.iter().map(|i| i.energy_J(chain)).sum()
    }
}

/// Shares a stretch of the string (its lower and upper end from the bit, m) out between the nodes, as metres, so
/// that every element keeps its centre of mass.
fn share_out(mesh: &Mesh, stretch: [f64; 2], mut give: impl FnMut(usize, f64)) {
    for i in 0..mesh.elements.len() {
        let (top, bottom) = (mesh.nodes[i].from_bit_m, mesh.nodes[i + 1].from_bit_m);
        let (low, high) = (stretch[0].max(bottom), stretch[1].min(top));
        if high > low {
            let upper = (0.5 * (low + high) - bottom) / (top - bottom);
            give(i, (high - low) * upper);
            give(i + 1, (high - low) * (1.0 - upper));
        }
    }
}
