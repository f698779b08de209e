//! The string at rest, as the computation of small motions about it reads it.

use nalgebra::{Matrix2, Vector2, Vector3};

use super::{
    StiffError, StiffSettings, contact, equilibrium::Equilibrium, judge::wall_N_per_m,
    solve::equilibrium, string_in_hole::high_side_rad,
};
use crate::{
    model::Model,
    operation::Operation,
    rod::{
        element::{Pose, Stiffness},
        mesh::Mesh,
        vector::Vector,
    },
};

/// A node at rest.
#[derive(Debug, Clone)]
pub struct NodeAtRest {
    /// Measured depth, m.
    pub md_m: f64,
    /// Two directions across the hole, and the hole's.
    pub axes: [Vector3<f64>; 3],
    /// Two directions across the string, and the string's.
    pub frame: [Vector3<f64>; 3],
    /// Offset from the hole's axis across it, m.
    pub offset_m: Vector2<f64>,
    /// Contact force, N.
    pub normal_N: f64,
    /// Stiffness against small motions across the hole, N/m: of the wall where the node touches it,
    /// and of the rock around the bit.
    pub held_N_per_m: Matrix2<f64>,
}

/// An element at rest.
#[derive(Debug, Clone, Copy)]
pub struct ElementAtRest {
    /// Its stiffness, with the rest length that gives it its tension.
    pub stiffness: Stiffness<f64>,
    /// Pose, twisted by its torque.
    pub pose: Pose<f64>,
}

/// The string at rest.
#[derive(Debug, Clone)]
pub struct AtRest {
    /// Mesh of the string.
    pub mesh: Mesh,
    /// From the top down.
    pub nodes: Vec<NodeAtRest>,
    /// From the top down.
    pub elements: Vec<ElementAtRest>,
    /// Direction of the high side at the bit in the axes across the hole, rad: the same at all
    /// nodes.
    pub high_side_rad: f64,
    /// Whether every small motion costs energy.
    pub stable: bool,
}

/// Computes the string of one operation at rest.
///
/// # Errors
/// As [`solve`](super::solve).
pub fn at_rest(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
) -> Result<AtRest, StiffError> {
    let equilibrium = equilibrium(model, operation, settings)?;
    Ok(AtRest::new(model, &equilibrium))
}

impl AtRest {
    fn new(model: &Model, solution: &Equilibrium) -> Self {
        let Equilibrium { mesh, string, state, convergence, .. } = solution;
        let nodes = string.nodes.iter().enumerate().map(|(index, node)| {
            let heading = &state.heading[index];
            let [b1, b2] = heading.across;
            let wall = wall_N_per_m(node, state, index).unwrap_or_else(Matrix2::zeros);
            NodeAtRest {
                md_m: node.md_m,
                axes: node.axes,
                frame: [b1, b2, heading.along],
                offset_m: state.offset_m[index].xy(),
                normal_N: state.normal_N[index],
                held_N_per_m: wall + Matrix2::identity() * node.hold_N_per_m,
            }
        });
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        let elements = string.elements.iter().enumerate().map(|(index, element)| {
            let k = element.stiffness;
            // The tension is EA/L times the excess of the chord and its bowing over this length.
            let stiffness = Stiffness { length: k.length + element.slack_m, ..k };
            ElementAtRest {
                pose: Pose {
                    anchor_chord: state.chord_m(string, index).into(),
                    anchor_excess: 0.0,
                    displacement: Vector::zero(),
                    velocity: Vector::zero(),
                    d1: element.seen(&state.heading[index]).into(),
                    d2: state.heading[index + 1].along.into(),
                    w1: Vector::zero(),
                    w2: Vector::zero(),
                    spin: 0.0,
                    // The torque of a string that is turned from above twists it back.
                    twist: -torques_N_m[index] / k.twist,
                },
                stiffness,
            }
        });
        Self {
            nodes: nodes.collect(),
            elements: elements.collect(),
            high_side_rad: high_side_rad(model, &string.nodes),
            stable: convergence.stable,
            mesh: mesh.clone(),
        }
    }
}
