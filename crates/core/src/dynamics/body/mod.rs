//! What is fixed in the body of the string and turns with it: bends and eccentric masses.

pub mod bend;
pub mod imbalance;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::{
    GRAVITY_M_PER_S2,
    damage::{Damaged, sound},
    dynamics::{
        body::{bend::Bend, imbalance::Imbalance},
        boundary::hole::Anchor,
        kernel::{
            chain::{Chain, element, node},
            step::StepInput,
        },
    },
    model::Model,
    rod::{self, bent::transported, element::Pose, mesh::Mesh},
    simd::{number::Real, vector::Vector},
};

/// Forces and moments on single nodes beside those of the step, all at the positions before it.
///
/// A force is added to the node's weight for one step, so that the step itself shares it out between wall,
/// friction and motion and books its losses right. A moment about the director is a kick of the spin before the step, so
/// that friction can take it back within it; one across the director a kick after it, for the moments of bends are
/// large and would show as turning in the twist and the damping of the neighbours. So would the kick of the spin: what
/// twist, damping, mud and friction make of it is taken out again, so that nothing is lost in a string at rest.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Loads {
    loads: Vec<Load>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Load {
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
const MOST_SLOWED: f64 = 0.5;

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
            spin: 0.0,
            spun: 0.0,
            slowed: 0.0,
        });
    }

    /// Loads the nodes. What the step will book too much to stiffness-proportional damping, J.
    fn apply(&mut self, chain: &mut Chain<impl Real>, input: &StepInput) -> f64 {
        let (dt, beta) = (input.dt, input.stiffness_damping);
        let mut excess_W = 0.0;
        for load in &mut self.loads {
            let index = load.index;
            load.weight = chain.weight(index);
            chain.set_weight(index, load.weight + load.force);
            let mobility = dt * node!(chain, index, inv_polar);
            load.slowed = (mobility * node!(chain, index, mud_spin)).min(MOST_SLOWED);
            // The mud takes its part of what a node comes with; of a kick it must leave all.
            load.spun = mobility * load.moment.dot(load.director) / (1.0 - load.slowed);
            load.friction = node!(chain, index, sum_torque);
            load.spin = node!(chain, index, spin);
            let lost_W = |chain: &_| damped_W(chain, index, beta);
            excess_W -= lost_W(chain);
            node!(chain, index, spin += load.spun);
            excess_W += lost_W(chain);
            // The step carries the twist on by the spin that it finds, and damps it: by that of half a step ago,
            // without this kick.
            twist_neighbours(chain, index, -(dt + beta) * load.spun);
        }
        excess_W * dt
    }

    /// Gives the weights back and turns the directors by the moments across them; takes what the step booked too much to
    /// friction out of its sums. What it booked too much to the mud, J: it took the kicks for spin that
    /// the nodes had before.
    fn finish(&mut self, chain: &mut Chain<impl Real>, input: &StepInput) -> f64 {
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

/// Work and losses of a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct BodyStep {
    /// Work put into the string.
    pub work_J: f64,
    /// Lost to stiffness-proportional damping beyond what the step books.
    pub damping_loss_J: f64,
    /// Lost to the mud beyond what the step books.
    pub mud_loss_J: f64,
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
            sum.damping_loss_J += step.loss_J;
        }
        for imbalance in &mut self.imbalances {
            imbalance.push(chain, input.dt, &mut self.loads);
        }
        sum.damping_loss_J -= self.loads.apply(chain, input);
        sum
    }

    /// Acts after the step and whatever else moves nodes in it.
    pub fn follow(&mut self, chain: &mut Chain<impl Real>, input: &StepInput) -> BodyStep {
        let mut sum = BodyStep::default();
        if self.is_empty() {
            return sum;
        }
        sum.mud_loss_J -= self.loads.finish(chain, input);
        for imbalance in &mut self.imbalances {
            imbalance.follow(chain, input.dt);
        }
        for bend in &mut self.bends {
            bend.follow(chain, input.dt);
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
