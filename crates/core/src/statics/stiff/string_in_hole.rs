//! The string in its hole: what the iterations do not change.

use nalgebra::Vector3;

use super::{
    heading::Heading,
    settings::{End, StiffSettings},
    wall::Compliance,
};
use crate::{
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    rod::{element::Stiffness, mesh::Mesh, tangent::Ends},
    statics::{
        circulation::{self, Circulating, Passage},
        sliding::Sliding,
        soft::SoftProfile,
    },
    wall::Bore,
};

/// Least room that a node has, m: a tool as large as its hole is held by its wall all around.
const LEAST_CLEARANCE_M: f64 = 1e-5;

/// A node.
#[derive(Debug, Clone)]
pub(super) struct Node {
    /// Its measured depth, m.
    pub(super) md_m: f64,
    /// Its place on the hole's axis, m.
    pub(super) anchor_m: Vector3<f64>,
    /// Two directions across the hole, carried along it without twisting, and the hole's.
    pub(super) axes: [Vector3<f64>; 3],
    /// How far it may go from the axis, m; infinite where no wall acts.
    pub(super) clearance_m: f64,
    /// How the wall gives way.
    pub(super) compliance: Compliance,
    /// Radius of what touches, m.
    pub(super) contact_radius_m: f64,
    /// Friction of a newton of contact force along the hole, positive towards the bit, and around
    /// it, against a positive rotation.
    pub(super) friction: [f64; 2],
    /// Weight and pull of the mud, N.
    pub(super) load_N: Vector3<f64>,
    /// What holds it to the hole's axis, N/m.
    pub(super) hold_N_per_m: f64,
    /// Contact force that the iterations begin with, N.
    pub(super) guess_N: f64,
}

impl Node {
    /// Whether a wall acts on it.
    pub(super) fn has_wall(&self) -> bool {
        self.clearance_m.is_finite()
    }
}

/// An element between a node and the next.
#[derive(Debug, Clone)]
pub(super) struct Element {
    /// Its stiffness.
    pub(super) stiffness: Stiffness<f64>,
    /// `g` of the element without tension, m: on the hole's axis it has the soft string's tension.
    pub(super) slack_m: f64,
    /// That tension, N.
    pub(super) guess_N: f64,
    /// Torque that the mud takes of its rotation, N·m.
    pub(super) mud_torque_N_m: f64,
    /// The director that it sees at its upper node, in parts of the node's frame: the last along
    /// the node's director. Other than that where the body has a bend.
    pub(super) bend: Option<Vector3<f64>>,
    /// How far its body may go from the hole's axis half-way, m.
    pub(super) body_clearance_m: f64,
}

impl Element {
    /// The director that it sees at its upper node.
    pub(super) fn seen(&self, heading: &Heading) -> Vector3<f64> {
        let [b1, b2] = heading.across;
        let parts = self.bend.unwrap_or_else(Vector3::z);
        b1 * parts.x + b2 * parts.y + heading.along * parts.z
    }
}

/// The string in its hole.
#[derive(Debug, Clone)]
pub(super) struct StringInHole {
    /// From the top down.
    pub(super) nodes: Vec<Node>,
    /// From the top down.
    pub(super) elements: Vec<Element>,
    /// How the top is held.
    pub(super) top: End,
    /// Torque of the bit, N·m.
    pub(super) bit_torque_N_m: f64,
    /// What the mud does; none without a rheology.
    pub(super) hydraulics: Option<Hydraulics>,
    /// What the flow does to each element.
    pub(super) circulating: Vec<Circulating>,
}

impl StringInHole {
    pub(super) fn new(
        model: &Model,
        operation: &Operation,
        settings: &StiffSettings,
        mesh: &Mesh,
        soft: &SoftProfile,
    ) -> Self {
        let bore = Bore::new(&model.well.hole);
        let depths = depths_m(model, &bore, operation.bit_depth_m, mesh, soft);
        let (circulating, hydraulics) = circulation(model, operation, mesh, &depths);
        let sliding = Sliding::of(operation);
        let mud_density = model.mud.density_kg_per_m3;
        let held_to_m = model.held_length_m();
        let last = mesh.nodes.len() - 1;
        let mut beside: Option<[Vector3<f64>; 2]> = None;
        let mut nodes: Vec<Node> = Vec::with_capacity(mesh.nodes.len());
        for (index, at) in mesh.nodes.iter().enumerate() {
            let md_m = depths[index];
            let wall = bore.at(&model.well.path, md_m);
            let tangent = wall.axis.tangent;
            let high = model.well.path.high_side_of(md_m, &tangent);
            // Carried from node to node by the least rotation.
            let first = match beside {
                None => high,
                Some([axis, above]) => {
                    let half = axis.dot(&tangent) / (1.0 + above.dot(&tangent));
                    axis - (above + tangent) * half
                }
            };
            let first = (first - tangent * tangent.dot(&first)).normalize();
            beside = Some([first, tangent]);
            let (_, component) = model.string.component_at(at.from_bit_m);
            let section = bore.section(md_m);
            let friction = section.friction;
            let (along, around) = sliding.direction(at.contact_radius_m);
            let touches = index != 0 && at.from_bit_m >= held_to_m;
            let room = wall.radius_m - at.contact_radius_m;
            nodes.push(Node {
                md_m,
                anchor_m: wall.axis.position_m,
                axes: [first, tangent.cross(&first), tangent],
                clearance_m: if touches { room.max(LEAST_CLEARANCE_M) } else { f64::INFINITY },
                compliance: Compliance::new(
                    &settings.contact_law,
                    component,
                    section,
                    bore.smooth_radius_m(md_m),
                    at.contact_radius_m,
                ),
                contact_radius_m: at.contact_radius_m,
                friction: [-friction.kinetic * along, friction.kinetic * friction.around * around],
                load_N: Vector3::zeros(),
                hold_N_per_m: if index == last {
                    settings.bit_lateral_stiffness_N_per_m
                } else {
                    0.0
                },
                guess_N: soft.side_force_at_N_per_m(md_m).abs() * mesh.tributary_length_m(index),
            });
        }
        let elements = (0..last)
            .map(|index| {
                let of = &mesh.elements[index];
                let weight_N = 0.5 * of.length_m * of.section.buoyed_weight_N_per_m(mud_density);
                let pull_N = 0.5 * of.length_m * circulating[index].pull_N_per_m;
                for node in &mut nodes[index..=index + 1] {
                    // A pull that adds to hook load points to the bit.
                    node.load_N += Vector3::z() * weight_N + node.axes[2] * pull_N;
                }
                let stiffness = Stiffness::new(&of.section, of.length_m);
                let middle_m = 0.5 * (depths[index] + depths[index + 1]);
                let guess_N = soft.tension_at_N(middle_m);
                let (upper, lower) = (&nodes[index], &nodes[index + 1]);
                let centred = Ends {
                    chord_m: lower.anchor_m - upper.anchor_m,
                    directors: [upper.axes[2], lower.axes[2]],
                };
                Element {
                    slack_m: centred.longer_m(&stiffness) - guess_N / stiffness.axial,
                    stiffness,
                    guess_N,
                    mud_torque_N_m: of.length_m * circulating[index].torque_N_m_per_m,
                    bend: None,
                    body_clearance_m: bore.smooth_radius_m(middle_m) - 0.5 * of.section.od_m,
                }
            })
            .collect();
        let jet_N = hydraulics.map_or(0.0, |mud| mud.jet_thrust_N);
        let bottom = &mut nodes[last];
        bottom.load_N -= bottom.axes[2] * (operation.weight_on_bit_now_N() + jet_N);
        let mut string = Self {
            nodes,
            elements,
            top: settings.top,
            bit_torque_N_m: operation.bit_torque_now_N_m(),
            hydraulics,
            circulating,
        };
        string.bend(model, mesh);
        string
    }

    /// Bends the elements below the bends of the body, at their tool faces: angles from the high
    /// side at the bit, clockwise as one looks down the hole, carried up the string without
    /// twisting.
    fn bend(&mut self, model: &Model, mesh: &Mesh) {
        let high_rad = self.high_side_rad(model);
        for span in model.string.spans() {
            let Some(bend) = span.component.bend else { continue };
            let index = mesh.nearest_inner_node(span.from_bit_m + bend.from_lower_end_m);
            let (sine, cosine) = (high_rad + bend.toolface_rad).sin_cos();
            let (across, along) = bend.angle_rad.sin_cos();
            self.elements[index].bend = Some(Vector3::new(across * cosine, across * sine, along));
        }
    }

    /// Direction of the high side at the bit in the axes across the hole, rad. The axes are carried
    /// along the hole: it has the same parts everywhere.
    pub(super) fn high_side_rad(&self, model: &Model) -> f64 {
        let bit = &self.nodes[self.nodes.len() - 1];
        let high = model.well.path.high_side_of(bit.md_m, &bit.axes[2]);
        high.dot(&bit.axes[1]).atan2(high.dot(&bit.axes[0]))
    }

    /// Mean weight of a node over its mean clearance, N/m: what a pipe that swings in its hole is
    /// held by.
    pub(super) fn swing_N_per_m(&self) -> f64 {
        let walled = self.nodes.iter().filter(|node| node.has_wall());
        let (sum_m, count) =
            walled.fold((0.0, 0.0), |(sum, count), node| (sum + node.clearance_m, count + 1.0));
        let clearance_m = if count > 0.0 { sum_m / count } else { 1.0 };
        self.weight_N() / self.nodes.len() as f64 / clearance_m
    }

    /// Buoyed weight of the string, N.
    pub(super) fn weight_N(&self) -> f64 {
        self.nodes.iter().map(|node| node.load_N.z.abs()).sum()
    }
}

/// Measured depths of the nodes of a string whose bit is at a depth, m: stretched by the soft string's
/// tension, and reaching farther on the inside of a bend than the hole's axis does.
fn depths_m(
    model: &Model,
    bore: &Bore,
    bit_depth_m: f64,
    mesh: &Mesh,
    soft: &SoftProfile,
) -> Vec<f64> {
    // What a metre of string on the wall is shorter by than a metre of axis.
    let inside = |index: usize, md_m: f64| {
        let clearance_m = bore.smooth_radius_m(md_m) - mesh.nodes[index].contact_radius_m;
        let curvature_per_m = model.well.path.at(md_m).curvature_per_m;
        clearance_m.max(0.0) * soft.contact_direction_at(md_m).dot(&curvature_per_m)
    };
    let mut depths = vec![bit_depth_m; mesh.nodes.len()];
    let mut below = inside(mesh.nodes.len() - 1, bit_depth_m);
    for index in (0..mesh.elements.len()).rev() {
        let element = &mesh.elements[index];
        let tension_N = soft.tension_at_N(depths[index + 1] - 0.5 * element.length_m);
        let strain = tension_N / element.section.axial_stiffness_N;
        let above = inside(index, depths[index + 1] - element.length_m);
        let longer = 1.0 + strain + 0.5 * (above + below);
        depths[index] = depths[index + 1] - element.length_m * longer;
        below = above;
    }
    depths
}

/// What the mud does to each element, from the top down.
fn circulation(
    model: &Model,
    operation: &Operation,
    mesh: &Mesh,
    depths_m: &[f64],
) -> (Vec<Circulating>, Option<Hydraulics>) {
    let passages: Vec<Passage> = (0..mesh.elements.len())
        .rev()
        .map(|index| {
            let element = &mesh.elements[index];
            let middle_m = 0.5 * (depths_m[index] + depths_m[index + 1]);
            Passage {
                length_m: element.length_m,
                od_m: element.section.od_m,
                bore_m2: element.section.bore_m2,
                hole_diameter_m: model.well.hole.at(middle_m).diameter_m,
                pressure_strain_per_Pa: element.section.pressure_strain_per_Pa,
            }
        })
        .collect();
    let (mut circulating, hydraulics) = circulation::along(model, operation, &passages);
    circulating.reverse();
    (circulating, hydraulics)
}
