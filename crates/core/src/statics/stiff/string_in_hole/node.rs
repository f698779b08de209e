//! The nodes, with the position and the wall of the hole around them.

use nalgebra::{Vector2, Vector3};

use super::super::{error::StiffSettings, wall::Compliance};
use crate::{
    model::Model,
    rod::mesh::Mesh,
    statics::{sliding::Sliding, soft::SoftProfile},
    wall::Bore,
};

/// Least clearance of a node, m: a tool as large as its hole is held by its wall all around.
const LEAST_CLEARANCE_M: f64 = 1e-5;

/// A node.
#[derive(Debug, Clone)]
pub(in super::super) struct Node {
    /// Measured depth, m.
    pub(in super::super) md_m: f64,
    /// Position on the hole's axis, m.
    pub(in super::super) anchor_m: Vector3<f64>,
    /// Two directions across the hole, carried along it without twisting, and the hole's.
    pub(in super::super) axes: [Vector3<f64>; 3],
    /// Clearance from the axis, m; infinite where no wall acts.
    pub(in super::super) clearance_m: f64,
    /// Compliance of the wall.
    pub(in super::super) compliance: Compliance,
    /// Radius of the surface that touches, m.
    pub(in super::super) contact_radius_m: f64,
    /// Friction of a newton of contact force along the hole, positive towards the bit, and around
    /// it, against a positive rotation.
    pub(in super::super) friction: [f64; 2],
    /// Weight, pull of the mud and other loads, N.
    pub(in super::super) load_N: Vector3<f64>,
    /// Stiffness that holds it to the hole's axis, N/m.
    pub(in super::super) hold_N_per_m: f64,
    /// Initial contact force of the iterations, N.
    pub(in super::super) guess_N: f64,
}

impl Node {
    /// Whether a wall acts on it.
    pub(in super::super) fn has_wall(&self) -> bool {
        self.clearance_m.is_finite()
    }

    /// Directions to the low side and to the side of it, in parts along the node's two axes; in a
    /// vertical hole the axes themselves.
    pub(in super::super) fn low_and_side(&self) -> [Vector2<f64>; 2] {
        let low = Vector2::new(self.axes[0].z, self.axes[1].z);
        let low = low.try_normalize(1e-6).unwrap_or_else(Vector2::x);
        [low, Vector2::new(-low.y, low.x)]
    }

    /// Whether the wall rubs on it.
    pub(in super::super) fn rubs(&self) -> bool {
        self.friction != [0.0, 0.0]
    }

    /// A direction across the hole by its parts along the node's two axes.
    pub(super) fn across(&self, angle_rad: f64) -> Vector3<f64> {
        let (sine, cosine) = libm::sincos(angle_rad);
        self.axes[0] * cosine + self.axes[1] * sine
    }
}

/// The nodes of a mesh at their depths, m, without loads.
pub(super) fn along(
    model: &Model,
    bore: &Bore,
    settings: &StiffSettings,
    mesh: &Mesh,
    depths_m: &[f64],
    (sliding, soft): (Sliding, &SoftProfile),
) -> Vec<Node> {
    let held_to_m = model.held_length_m();
    let last = mesh.nodes.len() - 1;
    let held_N_per_m = model.ends.bit.stiffness_N_per_m(settings.bit_lateral_stiffness_N_per_m);
    let mut previous: Option<[Vector3<f64>; 2]> = None;
    let mut nodes: Vec<Node> = Vec::with_capacity(mesh.nodes.len());
    for (index, at) in mesh.nodes.iter().enumerate() {
        let md_m = depths_m[index];
        let wall = bore.at(&model.well.path, md_m);
        let tangent = wall.axis.tangent;
        // Carried from node to node by the least rotation.
        let first = match previous {
            None => model.well.path.high_side_of(md_m, &tangent),
            Some([axis, above]) => {
                let half = axis.dot(&tangent) / (1.0 + above.dot(&tangent));
                axis - (above + tangent) * half
            }
        };
        let first = (first - tangent * tangent.dot(&first)).normalize();
        previous = Some([first, tangent]);
        let (_, component) = model.string.component_at(at.from_bit_m);
        let section = bore.section(md_m);
        let friction = section.friction;
        let (along, around) = sliding.direction(at.contact_radius_m);
        let touches = index != 0 && at.from_bit_m >= held_to_m;
        let room = wall.radius_m - at.contact_radius_m;
        // A rigid support is no spring: see the ends of the equations.
        let holds = index == last && held_N_per_m.is_finite();
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
            hold_N_per_m: if holds { held_N_per_m } else { 0.0 },
            guess_N: soft.side_force_at_N_per_m(md_m).abs() * mesh.tributary_length_m(index),
        });
    }
    nodes
}

/// Depths of the nodes of a string whose bit is at a depth: it is stretched by the soft string's
/// tension, and on the inside of a bend it spans more than its own length of the hole's axis.
pub(super) struct Depths {
    /// Measured depths, m, from the top down.
    pub(super) md_m: Vec<f64>,
    /// Excess of the length of the hole's axis that each element spans over its own length, m,
    /// where it is on the inside of a bend.
    pub(super) inside_m: Vec<f64>,
}

impl Depths {
    pub(super) fn new(
        model: &Model,
        bore: &Bore,
        bit_depth_m: f64,
        mesh: &Mesh,
        soft: &SoftProfile,
    ) -> Self {
        // Difference between a metre of axis and the string on the wall along it.
        let inside = |index: usize, md_m: f64| {
            let clearance_m = bore.smooth_radius_m(md_m) - mesh.nodes[index].contact_radius_m;
            let curvature_per_m = model.well.path.at(md_m).curvature_per_m;
            clearance_m.max(0.0) * soft.contact_direction_at(md_m).dot(&curvature_per_m)
        };
        let mut md = vec![bit_depth_m; mesh.nodes.len()];
        let mut inside_m = vec![0.0; mesh.elements.len()];
        let mut below = inside(mesh.nodes.len() - 1, bit_depth_m);
        for index in (0..mesh.elements.len()).rev() {
            let element = &mesh.elements[index];
            let tension_N = soft.tension_at_N(md[index + 1] - 0.5 * element.length_m);
            let strain = tension_N / element.section.axial_stiffness_N;
            let above = inside(index, md[index + 1] - element.length_m);
            inside_m[index] = 0.5 * (above + below) * element.length_m;
            md[index] = md[index + 1] - element.length_m * (1.0 + strain) - inside_m[index];
            below = above;
        }
        Self { md_m: md, inside_m }
    }
}
