//! Energy of the string in its hole. Of two states of a string without friction, the one with the
//! lower energy is the one that stays.

use super::{state::State, string_in_hole::StringInHole};

/// Strain energy of the elements and of the wall, less the work of weight and end loads since the
/// string was on the axis of its hole, J.
pub(super) fn energy_J(string: &StringInHole, state: &State) -> f64 {
    let elements = (0..string.elements.len()).map(|index| element_J(string, state, index));
    let nodes = string.nodes.iter().enumerate().map(|(index, node)| {
        let offset_m = state.offset_m[index];
        let held_J = 0.5 * node.hold_N_per_m * offset_m.xy().norm_squared();
        let load_J = node.load_N.dot(&state.moved_m(string, index));
        held_J + node.compliance.energy_J(state.normal_N[index]) - load_J
    });
    elements.sum::<f64>() + nodes.sum::<f64>()
}

/// `T² L/(2 EA) + (EI/L){A₀[(1 − c1²) + (1 − c2²)]/2 + B₀(c12 − c1 c2)}`, `c1`, `c2` the directors
/// along the chord and `c12` along each other.
fn element_J(string: &StringInHole, state: &State, index: usize) -> f64 {
    let element = &string.elements[index];
    let k = &element.stiffness;
    let chord = state.chord_m(string, index).normalize();
    let [upper, lower] = [element.seen(&state.heading[index]), state.heading[index + 1].along];
    // The components across the chord keep their digits where the angles are small.
    let across = [upper, lower].map(|director| director - chord * chord.dot(&director));
    let own = across[0].norm_squared() + across[1].norm_squared();
    let bent_J = 0.5 * k.bending_near() * own + k.bending_far * across[0].dot(&across[1]);
    let tension_N = state.tension_N[index];
    // The weight between its nodes sinks as the directors bow.
    let sunk_J = element.couple_N_m().dot(&(upper - lower));
    0.5 * tension_N * tension_N / k.axial + bent_J - sunk_J
}
