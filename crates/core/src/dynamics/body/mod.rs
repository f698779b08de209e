//! Bends and eccentric masses, which are fixed in the body of the string and turn with it.

pub mod bend;
pub mod imbalance;
pub mod loads;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::{
    GRAVITY_M_PER_S2,
    damage::{Damaged, ensure},
    dynamics::{
        body::{bend::Bend, imbalance::Imbalance, loads::Loads},
        boundary::anchor::Anchor,
        kernel::{
            chain::{Chain, NodeImbalance},
            step::StepInput,
        },
    },
    model::Model,
    mud::Densities,
    rod::{bent::transported, element::Pose, mesh::Mesh},
    simd::{number::Real, vector::Vector},
};

/// Work and losses of a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct BodyStep {
    /// Work put into the string.
    pub work_J: f64,
    /// Energy lost to stiffness-proportional damping in excess of the amount that the step books,
    /// J.
    pub damping_loss_J: f64,
    /// Energy lost to the mud in excess of the amount that the step books, J.
    pub mud_loss_J: f64,
}

/// The bends and the eccentric masses of a string.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Body {
    /// From the top down, at most one at a node.
    pub bends: Vec<Bend>,
    /// From the top down, at most one at a node. From the first step on the chain has those that
    /// the step itself takes care of.
    imbalances: Vec<Imbalance>,
    loads: Loads,
}

impl Body {
    /// Checks that stored bends and masses, and those of the stored chain, are at the nodes where
    /// the model has them.
    pub(super) fn check(&self, chain: &Chain<impl Real>, fresh: &Self) -> Result<(), Damaged> {
        let bends = |body: &Self| body.bends.iter().map(|bend| bend.index).collect::<Vec<_>>();
        let own = |body: &Self| body.imbalances.iter().map(|one| one.index).collect::<Vec<_>>();
        let mut masses: Vec<_> =
            own(self).into_iter().chain(chain.imbalances().map(|(index, _)| index)).collect();
        masses.sort_unstable();
        // Loads are of one step: they are made anew in the next.
        let fits =
            bends(self) == bends(fresh) && masses == own(fresh) && self.loads.loads.is_empty();
        ensure(fits, "the bends and eccentric masses")
    }

    /// Bends and eccentric masses of `model` on the nodes of `mesh`. Their directions are set by
    /// [`Self::orient`]: until then `toward` holds the part towards the high side and the part to
    /// the right of it.
    pub fn new(model: &Model, mesh: &Mesh) -> Self {
        let mut bends = Vec::<Bend>::new();
        for span in model.string.spans() {
            if let Some(bend) = span.component.bend {
                let index = mesh.nearest_inner_node(span.from_bit_m + bend.from_lower_end_m);
                let (sine, cosine) = libm::sincos(bend.toolface_rad);
                bends.push(Bend::new(index, bend.angle_rad, Vector(cosine, sine, 0.0)));
            }
        }
        bends.sort_by_key(|bend| bend.index);
        let imbalances = levers_kg_m(model, mesh)
            .iter()
            .enumerate()
            .filter(|(_, [x, y])| libm::hypot(*x, *y) > 0.0)
            .map(|(index, [x, y])| {
                let size = libm::hypot(*x, *y);
                let toward = Vector(x / size, y / size, 0.0);
                Imbalance::new(index, size, GRAVITY_M_PER_S2, toward)
            })
            .collect();
        Self { bends, imbalances, loads: Loads::default() }
    }

    /// The highest node that is loaded in addition to the step, itself or through the element
    /// below; greater than every node where there is none. Eccentric masses that are not at bends
    /// move in the step.
    pub fn highest(&self) -> usize {
        self.bends.iter().map(|bend| bend.index).min().unwrap_or(usize::MAX)
    }

    /// Adds an eccentric mass.
    #[cfg(test)]
    pub fn add(&mut self, imbalance: Imbalance) {
        self.imbalances.push(imbalance);
    }

    /// All eccentric masses, with their nodes: first those that act in addition to the step.
    pub fn imbalances(
        &self,
        chain: &Chain<impl Real>,
    ) -> impl Iterator<Item = (usize, NodeImbalance)> {
        let beside =
            self.imbalances.iter().map(|imbalance| (imbalance.index, imbalance.after_step()));
        beside.chain(chain.imbalances())
    }

    /// Leaves the masses to the step but for those on nodes that something acts on after it: the
    /// bit, or a bend above or below. The step of the uppermost region is `dt`.
    fn hand_over(&mut self, chain: &mut Chain<impl Real>, dt: f64) {
        let Self { bends, imbalances, .. } = self;
        let last = chain.nodes() - 1;
        imbalances.retain(|imbalance| {
            let index = imbalance.index;
            let bent = bends.iter().any(|bend| index == bend.index || index == bend.index + 1);
            let acted_on = bent || index == last;
            if !acted_on {
                let step_s = chain.step_s(index, dt);
                let node_imbalance = imbalance.before_step(chain, step_s);
                chain.set_imbalance(index, &node_imbalance);
            }
            acted_on
        });
    }

    /// Whether nothing acts in addition to the step.
    pub fn is_empty(&self) -> bool {
        self.bends.is_empty() && self.imbalances.is_empty()
    }

    /// Turns everything to its angle from the high side at the bit, clockwise as one looks down the
    /// hole, carried up the string without twisting.
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
        // The input is that of the lowest region.
        self.hand_over(chain, input.dt * f64::from(chain.parts()));
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
        let energy_J = |(index, of_node)| imbalance::energy_J(chain, index, &of_node);
        self.imbalances(chain).map(energy_J).sum()
    }
}

/// Imbalance of each node, kg·m: its part towards the high side at the start, and that to the right
/// of it as one looks down the hole. The top has none: it is clamped to its axis and turned by the
/// top drive.
pub fn levers_kg_m(model: &Model, mesh: &Mesh) -> Vec<[f64; 2]> {
    let mut levers = vec![[0.0; 2]; mesh.nodes.len()];
    let (column, bit_depth_m) = (model.mud_column(), model.string.length_m());
    for span in model.string.spans() {
        if let Some(eccentricity) = span.component.eccentricity {
            let mds_m = [bit_depth_m - span.to_bit_m, bit_depth_m - span.from_bit_m];
            let Densities { inside_kg_per_m3, .. } = column.mean_densities(mds_m);
            let moment = span.component.mass_per_length_kg_per_m
                * eccentricity.effective_offset_m(inside_kg_per_m3, &span.component.material);
            share_out(mesh, [span.from_bit_m, span.to_bit_m], |node, metres| {
                let lever = moment * metres;
                let (sine, cosine) = libm::sincos(eccentricity.phase_rad);
                levers[node][0] += lever * cosine;
                levers[node][1] += lever * sine;
            });
        }
    }
    levers[0] = [0.0; 2];
    levers
}

/// Shares a stretch of the string (its lower and upper end from the bit, m) out between the nodes,
/// as metres, so that every element keeps its centre of mass.
fn share_out(mesh: &Mesh, stretch: [f64; 2], mut give: impl FnMut(usize, f64)) {
    for i in 0..mesh.elements.len() {
        let (top, bottom) = (mesh.nodes[i].from_bit_m, mesh.nodes[i + 1].from_bit_m);
        let (low, high) = (stretch[0].max(bottom), stretch[1].min(top));
        if high > low {
            // By the lever of the stretch's middle between the two nodes.
            let upper = (0.5 * (low + high) - bottom) / (top - bottom);
            give(i, (high - low) * upper);
            give(i + 1, (high - low) * (1.0 - upper));
        }
    }
}
