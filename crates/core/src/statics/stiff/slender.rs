//! Elements that are too long for the compression on them: they buckle between their nodes, where
//! no wall supports them.

use super::string_in_hole::{Element, StringInHole};
use crate::rod::buckled_element::own_load_N;

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
