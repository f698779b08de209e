//! Errors of the mesh: the discretisation of the elements, and elements too long for their
//! compression.

use serde::{Deserialize, Serialize};

use super::string_in_hole::{Element, StringInHole};
use crate::{finite, rod::buckled_element::own_load_N};

/// Discretisation error of the elements, estimated from the last two meshes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct MeshError {
    /// Hook load, N.
    #[serde(with = "finite")]
    pub hook_load_N: f64,
    /// Surface torque, N·m.
    #[serde(with = "finite")]
    pub surface_torque_N_m: f64,
    /// Sum of the contact forces, N.
    #[serde(with = "finite")]
    pub side_force_total_N: f64,
    /// Bending moment at a node, N·m: the largest change.
    #[serde(with = "finite")]
    pub bending_moment_N_m: f64,
    /// Measured depth of that change, m.
    #[serde(with = "finite")]
    pub md_m: f64,
}

// Elements that are too long for the compression on them: they buckle between their nodes, where
// no wall supports them.

/// Elements per half wave of the buckled pipe, as in the rule that sizes compressed stretches.
const PER_HALF_WAVE: f64 = 4.0;

/// `π² EI/h²` of an element, N: under it a pipe that is hinged at its nodes buckles between them.
fn euler_load_N(element: &Element) -> f64 {
    let stiffness = &element.stiffness;
    own_load_N(stiffness.bending * stiffness.length, stiffness.length)
}

/// The element with the largest ratio of compression to its own buckling load, if that exceeds one.
pub(super) fn buckles(string: &StringInHole, tension_N: &[f64]) -> Option<usize> {
    let use_of = |index: usize| -tension_N[index] / euler_load_N(&string.elements[index]);
    let most = (0..tension_N.len()).max_by(|a, b| use_of(*a).total_cmp(&use_of(*b)))?;
    (use_of(most) > 1.0).then_some(most)
}

/// The elements that are too long for a compression, N, among those that it may reach, in which the
/// soft string's tension is below it. Half a wave is `π √(2 EI/F)`.
pub(super) fn too_long(string: &StringInHole, compression_N: f64) -> Vec<bool> {
    let within = |element: &Element| {
        let half_wave = (2.0 * euler_load_N(element) / compression_N).sqrt();
        half_wave >= PER_HALF_WAVE || element.guess_N > compression_N
    };
    string.elements.iter().map(|element| !within(element)).collect()
}
