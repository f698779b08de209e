//! From model and mesh to the chain that the time loop moves.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::{
    dynamics::{
        kernel::chain::{Chain, NO_WALL_M, Rows, node},
        settings::ContactLaw,
    },
    model::Model,
    rod::{
        element::{Pose, Stiffness},
        mesh::Mesh,
        stability::StepPlan,
    },
    simd::{number::Real, vector::Vector},
    wall::{Bore, BorePoint, contact},
    well::Path,
};

/// Most mud that is carried along outside, as a multiple of the mud that the pipe displaces: reached where
/// a pipe fills 82 % of its hole. The formula of the concentric annulus grows without bound where a tool
/// fills its hole, for it has the mud go round it in a plane; round a stabiliser or a bit, no longer than its hole is
/// wide, most of it goes round the ends.
const MOST_ADDED_MUD: f64 = 5.0;

/// Where a node's anchor stands on the hole's axis.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Anchor {
    /// Measured depth, m.
    pub md_m: f64,
    /// Position, m.
    pub position_m: Vector3<f64>,
    /// Unit vector across the axis towards the high side.
    pub high_side: Vector3<f64>,
}

/// The hole around the chain: what a node takes up anew as it slides along.
#[derive(Debug, Clone)]
pub struct Surroundings {
    path: Path,
    bore: Bore,
    law: ContactLaw,
    /// Young's modulus and Poisson's ratio of each node's steel.
    steel: Vec<(f64, f64)>,
    /// Contact radius of each node, m; none where the wall does not act: at the top and where the bit is held.
    touches: Vec<Option<f64>>,
    /// Contact radius of the nodes at the lower end that are held to the hole's axis, m.
    held_radii_m: Vec<f64>,
    /// A node takes up a new anchor when it has slid this far, m.
    reach_m: f64,
    /// Whether the wall asks for all that a step can do: friction at rest above the kinetic one, friction
    /// around the hole other than along it, or a radius that undulates. Only then do cones have a slope, too.
    pub intricate: bool,
}

/// A bit with less clearance than this fills its hole, m: contact and friction of its body would be those
/// of a pipe that whirls in half a millimetre.
const SNUG_M: f64 = 2e-3;

/// Length of a bit over its diameter, at most: as much is held of a string that names no bit.
const BIT_DIAMETERS: f64 = 2.0;

/// Lateral mass of each element, kg/m: steel, mud inside, and the mud that an accelerated cylinder
/// carries along in an annulus, `ρ π r² (R² + r²)/(R² − r²)`.
pub fn lateral_mass_kg_per_m(model: &Model, mesh: &Mesh, bit_md_m: f64) -> Vec<f64> {
    let density = model.mud.density_kg_per_m3;
    mesh.elements
        .iter()
        .zip(&mesh.nodes)
        .map(|(element, top)| {
            let section = &element.section;
            let md = bit_md_m - top.from_bit_m + 0.5 * element.length_m;
            let hole = 0.5 * model.well.hole.at(md).diameter_m;
            let r = 0.5 * section.od_m;
            let (r2, hole2) = (r * r, hole * hole);
            let confined = ((hole2 + r2) / (hole2 - r2).max(1e-12)).min(MOST_ADDED_MUD);
            let outside = std::f64::consts::PI * r2 * confined;
            section.steel_kg_per_m + density * (section.bore_m2 + outside)
        })
        .collect()
}

/// Length of the lower end that is held to the hole's axis instead of touching the wall, m.
///
/// The lowest node always is. Where the first component fills the drilled hole, all of it is if it is a
/// [bit](crate::string::Component::is_bit); of a motor or a collar without a bit no more than a bit's length, for its
/// body is pressed against the wall like any other.
fn held_length_m(model: &Model) -> f64 {
    let lowest = &model.string.components()[0];
    let drilled = 0.5 * model.well.hole.at(model.string.length_m()).diameter_m;
    if drilled - 0.5 * lowest.od_m >= SNUG_M {
        return f64::MIN_POSITIVE;
    }
    if lowest.is_bit() {
        lowest.length_m
    } else {
        lowest.length_m.min(BIT_DIAMETERS * lowest.od_m)
    }
}

impl Surroundings {
    /// The surroundings of a chain made of `mesh`.
    pub fn new(model: &Model, mesh: &Mesh, law: ContactLaw) -> Self {
        let steel = mesh
            .nodes
            .iter()
            .map(|n| {
                let (_, component) = model.string.component_at(n.from_bit_m);
                (
                    component.material.youngs_modulus_Pa,
                    component.material.poisson_ratio(),
                )
            })
            .collect();
        // The top is clamped in the rotary; the bit is held by the hole that it cuts.
        let held_to_m = held_length_m(model);
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

    /// How deep the nodes lie in the wall that are held to the hole's axis and so do not feel it, m: the deepest, by their
    /// offset and their clearance; negative where all of them are inside the hole. A bit that cuts sideways takes its
    /// hole along: `cut` is how far.
    pub fn held_penetration_m(
        &self,
        chain: &Chain<impl Real>,
        anchors: &[Anchor],
        cut: Vector<f64>,
    ) -> f64 {
        let first = chain.nodes() - self.held_radii_m.len();
        let depths = self
            .held_radii_m
            .iter()
            .zip(first..)
            .map(|(radius, index)| {
                let (tangent, u) = (chain.tangent(index), chain.displacement(index));
                let z = u.dot(tangent);
                let offset = u
                    .minus(tangent, z)
                    .minus(chain.curvature(index), 0.5 * z * z)
                    .minus(cut, 1.0);
                let wall = self.bore.at(&self.path, anchors[index].md_m + z);
                // A hole that is tighter than the tool just holds it.
                offset.dot(offset).sqrt() - (wall.radius_m - radius).max(0.0)
            });
        depths.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Diameter of the hole at a measured depth, m.
    pub fn hole_diameter_m(&self, md_m: f64) -> f64 {
        self.bore.section(md_m).diameter_m
    }

    /// Puts a node's anchor at `md_m`, the node itself staying where it is.
    pub fn anchor(
        &self,
        chain: &mut Chain<impl Real>,
        anchors: &mut [Anchor],
        index: usize,
        md_m: f64,
    ) {
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
        anchors[index] = Anchor {
            md_m,
            position_m: axis.position_m,
            high_side: self.path.high_side_at(md_m),
        };
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
        // Where the wall is rougher than the tool is slim, the hole just holds it.
        let clearance = wall.radius_m - radius;
        let closed = clearance < 0.0;
        node!(chain, index, clearance = clearance.max(0.0));
        node!(
            chain,
            index,
            clearance_slope = if closed || !self.intricate {
                0.0
            } else {
                wall.slope
            }
        );
        let hole = self.bore.smooth_radius_m(md_m);
        let section = self.bore.section(md_m);
        node!(chain, index, radius = radius);
        node!(chain, index, friction = section.friction.kinetic);
        node!(
            chain,
            index,
            friction_rise = section.friction.at_rest - section.friction.kinetic
        );
        node!(chain, index, friction_around = section.friction.around);
        match self.law {
            ContactLaw::Hertz { .. } => {
                let (e, nu) = self.steel[index];
                let modulus = contact::contact_modulus_Pa(
                    e,
                    nu,
                    section.youngs_modulus_Pa,
                    section.poisson_ratio,
                );
                node!(
                    chain,
                    index,
                    stiffness = contact::hertz_stiffness(modulus, hole, radius)
                );
            }
            ContactLaw::Linear {
                stiffness_N_per_m,
                damping_ratio,
            } => {
                let mass = node!(chain, index, mass_lateral);
                node!(chain, index, stiffness = stiffness_N_per_m);
                node!(
                    chain,
                    index,
                    damping = 2.0 * damping_ratio * (stiffness_N_per_m * mass).sqrt()
                );
            }
        }
    }

    /// Moves the anchors of nodes that slid beyond their reach, the chords between them, and the nodes' high
    /// sides; whether there were any.
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
            // All that will be there soon go at once: looking for them takes longer than moving them.
            let moved = along.abs() > 0.8 * self.reach_m;
            if moved {
                let md = anchors[index].md_m + along;
                self.anchor(chain, anchors, index, md);
                note_high_side(high, chain.layout().place(index), &anchors[index]);
            }
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

/// The chain with its inertia, stiffness, weight and drag; nothing is placed yet.
pub fn chain(model: &Model, mesh: &Mesh, plan: &StepPlan) -> Chain {
    let mut chain = Chain::patterned(mesh.nodes.len(), mesh.nodes_per_joint());
    let mud = &model.mud;
    let last = mesh.nodes.len() - 1;
    for (index, element) in mesh.elements.iter().enumerate() {
        let section = &element.section;
        let inertia = &plan.inertia[index];
        chain.set_stiffness(index, &Stiffness::new(section, element.length_m));
        let half = 0.5 * element.length_m;
        let weight = half * section.buoyed_weight_N_per_m(mud.density_kg_per_m3);
        for end in [index, index + 1] {
            node!(chain, end, mass_axial += 0.5 * inertia.axial_kg);
            node!(chain, end, mass_lateral += 0.5 * inertia.lateral_kg);
            node!(chain, end, polar += 0.5 * inertia.polar_kg_m2);
            // Summed here, inverted below.
            node!(chain, end, inv_rotary += inertia.rotary_kg_m2);
            node!(chain, end, drag_linear += half * mud.linear_drag_Pa_s);
            node!(
                chain,
                end,
                drag_quadratic +=
                    half * 0.5 * mud.density_kg_per_m3 * mud.drag_coefficient * section.od_m
            );
            let mut total = chain.weight(end);
            total.2 += weight;
            chain.set_weight(end, total);
        }
    }
    for index in 0..=last {
        let rotary = node!(chain, index, inv_rotary);
        node!(
            chain,
            index,
            gyroscopic = node!(chain, index, polar) / rotary
        );
        node!(chain, index, inv_rotary = 1.0 / rotary);
    }
    release(&mut chain);
    chain
}

/// Frees the axial motion and the spin of all nodes, but for the spin of the top, which the top drive
/// prescribes. The top is clamped laterally: it neither leaves the axis nor tilts.
pub fn release(chain: &mut Chain) {
    for index in 0..chain.nodes() {
        node!(
            chain,
            index,
            inv_mass_axial = 1.0 / node!(chain, index, mass_axial)
        );
        node!(
            chain,
            index,
            inv_mass_lateral = 1.0 / node!(chain, index, mass_lateral)
        );
        node!(chain, index, inv_polar = 1.0 / node!(chain, index, polar));
    }
    node!(chain, 0, inv_mass_lateral = 0.0);
    node!(chain, 0, inv_rotary = 0.0);
    node!(chain, 0, gyroscopic = 0.0);
    node!(chain, 0, inv_polar = 0.0);
}

/// Holds the axial motion and the spin of all nodes: what is left is lateral.
pub fn hold(chain: &mut Chain) {
    for block in &mut chain.node_blocks {
        block.inv_mass_axial.0.fill(0.0);
        block.inv_polar.0.fill(0.0);
    }
}

/// How an element stood half a step before, where the velocities are.
pub(in crate::dynamics) fn half_a_step_before(mut pose: Pose<f64>, dt: f64) -> Pose<f64> {
    let half = 0.5 * dt;
    pose.displacement = pose.displacement.minus(pose.velocity, half);
    let back = |d: Vector<f64>, w: Vector<f64>| {
        let turned = d.minus(w.cross(d), half);
        turned.scaled(1.0 / turned.dot(turned).sqrt())
    };
    pose.d1 = back(pose.d1, pose.w1);
    pose.d2 = back(pose.d2, pose.w2);
    // The stored twist is that of the step's beginning.
    let share = 1.0 / (1.0 + pose.d1.dot(pose.d2));
    pose.twist += half * (pose.spin + share * (pose.w2.dot(pose.d1) - pose.w1.dot(pose.d2)));
    pose
}

/// Weight of the node at the top of the chain along the hole, N: part of the hook load.
pub fn top_weight_N(chain: &Chain<impl Real>) -> f64 {
    chain.weight(0).dot(chain.tangent(0))
}
