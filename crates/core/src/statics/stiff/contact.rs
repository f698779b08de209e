//! What the wall does to the nodes: normal force and the friction that goes with it.

use nalgebra::{Matrix2, Vector2, Vector3};

use super::string_in_hole::{Node, StringInHole};

/// A quarter turn about the hole's direction.
const QUARTER: Matrix2<f64> = Matrix2::new(0.0, -1.0, 1.0, 0.0);

/// Force on a node for each newton of contact force, and how it changes with the node's place
/// across the hole, 1/m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Push {
    /// In the hole's axes there.
    pub(super) force: Vector3<f64>,
    /// Of its two parts across.
    pub(super) change: Matrix2<f64>,
}

/// The rotational friction for each newton.
fn around(node: &Node) -> Matrix2<f64> {
    Matrix2::identity() + QUARTER * node.friction[1]
}

impl Push {
    /// Of a wall that pushes towards the axis by `|u|/c` of the contact force, `c` the room that
    /// there is: smooth on the axis, too.
    pub(super) fn smooth(node: &Node, offset_m: &Vector2<f64>) -> Self {
        let around = around(node) / node.clearance_m;
        let across = -around * offset_m;
        Self { force: Vector3::new(across.x, across.y, node.friction[0]), change: -around }
    }

    /// Of the wall itself, at a direction from the axis and a distance, m.
    pub(super) fn exact(node: &Node, direction: &Vector2<f64>, radius_m: f64) -> Self {
        let around = around(node);
        let across = -around * direction;
        let turning = (Matrix2::identity() - direction * direction.transpose()) / radius_m;
        Self {
            force: Vector3::new(across.x, across.y, node.friction[0]),
            change: -around * turning,
        }
    }
}

/// Torque that each element carries, N·m, from the contact forces of the nodes below it.
pub(super) fn torques_N_m(string: &StringInHole, normal_N: &[f64]) -> Vec<f64> {
    let mut torque_N_m = string.bit_torque_N_m;
    let mut torques = vec![0.0; string.elements.len()];
    for (index, element) in string.elements.iter().enumerate().rev() {
        torque_N_m += rubbed_N_m(&string.nodes[index + 1], normal_N[index + 1]);
        // That of the element's middle: half of its mud's lies below.
        torques[index] = torque_N_m + 0.5 * element.mud_torque_N_m;
        torque_N_m += element.mud_torque_N_m;
    }
    torques
}

/// Torque of friction on a node, N·m.
pub(super) fn rubbed_N_m(node: &Node, normal_N: f64) -> f64 {
    node.friction[1] * normal_N * node.contact_radius_m
}
