//! Force of the wall on the nodes: normal force and the friction proportional to it.

use nalgebra::{Matrix2, Vector2, Vector3};

use super::string_in_hole::{Node, StringInHole};

/// A quarter turn about the hole's direction.
const QUARTER: Matrix2<f64> = Matrix2::new(0.0, -1.0, 1.0, 0.0);

/// Force on a node per newton of contact force, and its derivative with respect to the node's
/// position across the hole, 1/m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Push {
    /// In the hole's axes there.
    pub(super) force: Vector3<f64>,
    /// Derivative of its two components across the hole.
    pub(super) change: Matrix2<f64>,
}

/// Normal force and rotational friction per newton.
fn around(node: &Node) -> Matrix2<f64> {
    Matrix2::identity() + QUARTER * node.friction[1]
}

impl Push {
    /// Push of a smoothed wall, which is `|u|/c` of the contact force towards the axis with `c` the
    /// clearance, and so is smooth on the axis, too.
    pub(super) fn smooth(node: &Node, offset_m: &Vector2<f64>) -> Self {
        let around = around(node) / node.clearance_m;
        let across = -around * offset_m;
        Self { force: Vector3::new(across.x, across.y, node.friction[0]), change: -around }
    }

    /// Push of the wall itself, at a direction and a distance from the axis, m.
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

/// Computes the torque in each element, N·m, from the contact forces of the nodes below it.
pub(super) fn torques_N_m(string: &StringInHole, normal_N: &[f64]) -> Vec<f64> {
    let mut torque_N_m = string.bit_torque_N_m;
    let mut torques = vec![0.0; string.elements.len()];
    for (index, element) in string.elements.iter().enumerate().rev() {
        torque_N_m += rubbed_N_m(&string.nodes[index + 1], normal_N[index + 1]);
        // At the element's middle: half of the torque of its mud acts below.
        torques[index] = torque_N_m + 0.5 * element.mud_torque_N_m;
        torque_N_m += element.mud_torque_N_m;
    }
    torques
}

/// Torque of friction on a node, N·m.
pub(super) fn rubbed_N_m(node: &Node, normal_N: f64) -> f64 {
    node.friction[1] * normal_N * node.contact_radius_m
}
