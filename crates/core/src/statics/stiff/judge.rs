//! Whether a state is an equilibrium, and whether it is stable.

use nalgebra::{Matrix2, Vector2};

use super::{
    active_set,
    contact::{self, Push},
    equations::Equations,
    equilibrium::Convergence,
    state::State,
    string_in_hole::{Node, StringInHole},
};

/// Largest unbalanced force of an equilibrium, as a part of the string's weight.
const RESIDUAL: f64 = 1e-8;

/// Motions whose stiffness is below this part of the foundation by weight count as neutral, because
/// a buckled pipe in a vertical hole can move around it.
const NEUTRAL: f64 = 1e-5;

/// Converges the contact exactly and assesses the result; none where it is no equilibrium.
pub(super) fn finish(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
    iterations: &mut usize,
) -> Option<Convergence> {
    let found = active_set::iterate(string, state, equations).ok()?;
    *iterations += found.count;
    if !found.converged {
        return None;
    }
    let (_, residual_N) = unbalanced(string, state, equations);
    let residual = residual_N / string.weight_N();
    Some(Convergence {
        elements: string.elements.len(),
        iterations: *iterations,
        residual,
        stable: is_stable(string, state, equations),
        rolls_at_md_m: None,
        mesh_error: None,
        finer_helix: None,
        buckled_element: None,
    })
    .filter(|_| residual < RESIDUAL)
}

/// The node with the largest unbalanced force, and that force, N.
pub(super) fn residual(
    string: &StringInHole,
    state: &State,
    equations: &mut Equations,
) -> (usize, f64) {
    let torques_N_m = contact::torques_N_m(string, &state.normal_N);
    equations.assemble(string, state, Some(&torques_N_m));
    unbalanced(string, state, equations)
}

/// The same for a state whose equations are assembled.
fn unbalanced(string: &StringInHole, state: &State, equations: &Equations) -> (usize, f64) {
    let mut worst = (0, equations.misfit_N());
    for (index, node) in string.nodes.iter().enumerate().skip(1) {
        let mut force = equations.force[index].fixed_rows::<3>(0).into_owned();
        if state.normal_N[index] > 0.0 {
            let (direction, radius_m) = direction(state, index);
            force += Push::exact(node, &direction, radius_m).force * state.normal_N[index];
        }
        if force.norm() > worst.1 {
            worst = (index, force.norm());
        }
    }
    worst
}

fn direction(state: &State, index: usize) -> (Vector2<f64>, f64) {
    let offset = state.offset_m[index].xy();
    let radius_m = offset.norm();
    (offset / radius_m.max(f64::MIN_POSITIVE), radius_m)
}

/// Whether every small motion costs energy, with the compliance of the wall where the string
/// touches it. The equations are those of the state, and are overwritten.
fn is_stable(string: &StringInHole, state: &State, equations: &mut Equations) -> bool {
    equations.untwist(string, state, &contact::torques_N_m(string, &state.normal_N));
    for (index, node) in string.nodes.iter().enumerate() {
        if let Some(wall_N_per_m) = wall_N_per_m(node, state, index) {
            let mut across = equations.matrix.diagonal[index].fixed_view_mut::<2, 2>(0, 0);
            across += wall_N_per_m;
        }
    }
    equations.is_definite(NEUTRAL * string.foundation_N_per_m())
}

/// Stiffness of the wall against small motions of a node across the hole, N/m: its compliance acts
/// along the normal, and around the hole its force turns with the node. None without contact.
pub(super) fn wall_N_per_m(node: &Node, state: &State, index: usize) -> Option<Matrix2<f64>> {
    let normal_N = state.normal_N[index];
    (normal_N > 0.0).then(|| {
        let (direction, radius_m) = direction(state, index);
        let radial = direction * direction.transpose();
        let (_, gives_m_per_N) = node.compliance.penetration_m(normal_N);
        radial / gives_m_per_N + (Matrix2::identity() - radial) * (normal_N / radius_m)
    })
}

// Energy of the string in its hole. Of two states of a string without friction, the one with the
// lower energy is the one that stays.

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
