//! The hole around the chain.

use nalgebra::Vector3;

use super::anchor::Anchor;
use crate::{
    dynamics::kernel::chain::{Chain, NO_WALL_M, Rows, node},
    model::Model,
    rod::mesh::Mesh,
    simd::{number::Real, vector::Vector},
    wall::{
        Bore, BorePoint,
        contact::{self, ContactLaw},
    },
    well::{Friction, Hole, Path},
};

/// The hole around the chain: the properties that are updated at a node as it slides along.
#[derive(Debug, Clone)]
pub struct Borehole {
    path: Path,
    bore: Bore,
    law: ContactLaw,
    /// Young's modulus and Poisson's ratio of each node's steel.
    steel: Vec<(f64, f64)>,
    /// Contact radius of each node, m; none where the wall does not act: at the top and where the
    /// bit is held.
    touches: Vec<Option<f64>>,
    /// Contact radius of the nodes at the lower end that are held to the hole's axis, m.
    held_radii_m: Vec<f64>,
    /// Sliding distance after which a node gets a new anchor, m.
    reach_m: f64,
    /// Whether the wall requires all that a step can do: friction at rest above the kinetic one,
    /// rotational friction other than along it, or a radius that undulates. Only then do cones
    /// have a slope, too.
    pub intricate: bool,
}

impl Borehole {
    /// The borehole around a chain made of `mesh`.
    pub fn new(model: &Model, mesh: &Mesh, law: ContactLaw) -> Self {
        let steel = mesh
            .nodes
            .iter()
            .map(|n| {
                let (_, component) = model.string.component_at(n.from_bit_m);
                (component.material.youngs_modulus_Pa, component.material.poisson_ratio())
            })
            .collect();
        // The top is clamped in the rotary; the bit is held by the hole that it cuts.
        let held_to_m = model.held_length_m();
        let touches: Vec<Option<f64>> = mesh
            .nodes
            .iter()
            .enumerate()
            .map(|(i, n)| (i != 0 && n.from_bit_m >= held_to_m).then_some(n.contact_radius_m))
            .collect();
        let held_radii_m = mesh
            .nodes
            .iter()
            .skip(1)
            .filter(|n| n.from_bit_m < held_to_m)
            .map(|n| n.contact_radius_m)
            .collect();
        let bore = Bore::new(&model.well.hole);
        Self {
            path: model.well.path.clone(),
            reach_m: bore.reach_m(),
            intricate: bore.undulates()
                || model
                    .well
                    .hole
                    .sections()
                    .iter()
                    .any(|s| s.friction.at_rest > s.friction.kinetic || s.friction.around != 1.0),
            bore,
            law,
            steel,
            touches,
            held_radii_m,
        }
    }

    /// Greatest penetration into the wall, m, of the nodes that are fixed to the hole's axis and so
    /// have no contact force, from their offset and their clearance; negative where all of them are
    /// inside the hole. A bit that cuts sideways moves its hole by `cut`.
    pub fn held_penetration_m(
        &self,
        chain: &Chain<impl Real>,
        anchors: &[Anchor],
        cut: Vector<f64>,
    ) -> f64 {
        let first = chain.nodes() - self.held_radii_m.len();
        let depths = self.held_radii_m.iter().zip(first..).map(|(radius, index)| {
            let (tangent, u) = (chain.tangent(index), chain.displacement(index));
            let z = u.dot(tangent);
            let offset =
                u.minus(tangent, z).minus(chain.curvature(index), 0.5 * z * z).minus(cut, 1.0);
            let wall = self.bore.at(&self.path, anchors[index].md_m + z);
            // A hole that is tighter than the tool just holds it.
            offset.dot(offset).sqrt() - (wall.radius_m - radius).max(0.0)
        });
        depths.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The coefficients of friction at a measured depth, m.
    pub fn friction(&self, md_m: f64) -> Friction {
        self.bore.section(md_m).friction
    }

    /// Takes the friction of another hole, which is the same but for it, to the nodes that feel the
    /// wall: they have the section's in which their anchors are.
    pub fn set_friction_of(
        &mut self,
        hole: Hole,
        chain: &mut Chain<impl Real>,
        anchors: &[Anchor],
    ) {
        self.bore.set_friction_of(hole);
        for (index, anchor) in anchors.iter().enumerate() {
            if self.touches[index].is_some() {
                self.rub(chain, index, self.friction(anchor.md_m));
            }
        }
    }

    /// The same for a resumed run, whose nodes already have it.
    pub fn resume_friction_of(&mut self, hole: Hole) {
        self.bore.set_friction_of(hole);
    }

    /// Gives a node its coefficients of friction.
    fn rub(&self, chain: &mut Chain<impl Real>, index: usize, friction: Friction) {
        node!(chain, index, friction = friction.kinetic);
        node!(chain, index, friction_rise = friction.at_rest - friction.kinetic);
        node!(chain, index, friction_around = friction.around);
    }

    /// Puts a node's anchor at `md_m`, the node itself staying where it is.
    pub fn anchor(
        &self,
        chain: &mut Chain<impl Real>,
        anchors: &mut [Anchor],
        index: usize,
        md_m: f64,
    ) {
        // The node keeps its place in the world; its displacement is counted from the new anchor.
        let there = anchors[index].position_m + Vector3::from(chain.displacement(index));
        self.place(chain, anchors, index, md_m);
        chain.set_displacement(index, (there - anchors[index].position_m).into());
    }

    /// Puts a node's anchor at `md_m` and takes the node along.
    pub fn place(
        &self,
        chain: &mut Chain<impl Real>,
        anchors: &mut [Anchor],
        index: usize,
        md_m: f64,
    ) {
        let wall = self.bore.at(&self.path, md_m);
        let axis = &wall.axis;
        anchors[index] =
            Anchor { md_m, position_m: axis.position_m, high_side: self.path.high_side_at(md_m) };
        chain.set_tangent(index, axis.tangent.into());
        chain.set_curvature(index, axis.curvature_per_m.into());
        self.meet_wall(chain, index, md_m, &wall);
    }

    /// Gives a node the wall at `md_m`.
    fn meet_wall(&self, chain: &mut Chain<impl Real>, index: usize, md_m: f64, wall: &BorePoint) {
        let Some(radius) = self.touches[index] else {
            node!(chain, index, clearance = NO_WALL_M);
            return;
        };
        // Where the wall is rougher than the tool is slim, the clearance is zero.
        let clearance = wall.radius_m - radius;
        let closed = clearance < 0.0;
        node!(chain, index, clearance = clearance.max(0.0));
        node!(
            chain,
            index,
            clearance_slope = if closed || !self.intricate { 0.0 } else { wall.slope }
        );
        // Roughness moves the wall but does not change its stiffness.
        let hole = self.bore.smooth_radius_m(md_m);
        let section = self.bore.section(md_m);
        node!(chain, index, radius = radius);
        self.rub(chain, index, section.friction);
        match self.law {
            ContactLaw::Hertz { .. } => {
                let (e, nu) = self.steel[index];
                let modulus = contact::contact_modulus_Pa(
                    e,
                    nu,
                    section.youngs_modulus_Pa,
                    section.poisson_ratio,
                );
                node!(chain, index, stiffness = contact::hertz_stiffness(modulus, hole, radius));
            }
            ContactLaw::Linear { stiffness_N_per_m, damping_ratio } => {
                let mass = node!(chain, index, mass_lateral);
                node!(chain, index, stiffness = stiffness_N_per_m);
                node!(
                    chain,
                    index,
                    // c = 2 ζ √(k m).
                    damping = 2.0 * damping_ratio * (stiffness_N_per_m * mass).sqrt()
                );
            }
        }
    }

    /// Moves the anchors of nodes that slid beyond their reach, the chords between them, and the
    /// nodes' high sides; whether there were any.
    pub fn follow(
        &self,
        chain: &mut Chain<impl Real>,
        anchors: &mut [Anchor],
        high: &mut [Rows<f64>],
    ) -> bool {
        // A hundredth shorter: the sum of three products is rounded otherwise.
        if !chain.slid(0.99 * self.reach_m) {
            return false;
        }
        let (mut moved_above, mut any) = (false, false);
        for index in 0..chain.nodes() {
            let along = chain.tangent(index).dot(chain.displacement(index));
            // All that will be there soon go at once: looking for them takes longer than moving
            // them.
            let moved = along.abs() > 0.8 * self.reach_m;
            if moved {
                let md = anchors[index].md_m + along;
                self.anchor(chain, anchors, index, md);
                note_high_side(high, chain.layout().place(index), &anchors[index]);
            }
            // A chord changes with either anchor.
            if index > 0 && (moved || moved_above) {
                span(chain, anchors, index - 1);
            }
            moved_above = moved;
            any |= moved;
        }
        any
    }
}

/// Writes a node's high side down at its place among those of all nodes.
pub fn note_high_side(high: &mut [Rows<f64>], (block, lane): (usize, usize), anchor: &Anchor) {
    for (axis, side) in high[block].iter_mut().zip(anchor.high_side.iter()) {
        axis.0[lane] = *side;
    }
}

/// Sets the anchor chord of an element from its two anchors.
pub fn span(chain: &mut Chain<impl Real>, anchors: &[Anchor], index: usize) {
    let chord = anchors[index + 1].position_m - anchors[index].position_m;
    chain.set_anchor_chord(index, chord.into());
}
