//! From a model and an operation to the string at rest.

use nalgebra::{Matrix2, Vector2};

use super::{
    StiffError, StiffProfile, StiffSettings, active_set,
    barrier::Barrier,
    contact::{self, Push},
    equations::Equations,
    equilibrium::{Convergence, Equilibrium},
    interior_point::{self, Begins},
    state::State,
    string_in_hole::{Node, StringInHole},
};
use crate::{
    model::Model,
    operation::Operation,
    rod::mesh::Mesh,
    sizing::{ElementLength, Sizing},
    statics::soft::{self, SoftSettings},
};

/// Forces out of balance that an equilibrium may have, as a part of the string's weight.
const RESIDUAL: f64 = 1e-8;

/// First product of force and room of a barrier, and the one from which the interior point goes on,
/// as parts of the mean weight of a node times its clearance.
const FIRST: f64 = 1.0;
const LAST: f64 = 1e-4;

/// First product of a later round over its last.
const LATER: f64 = 100.0;

/// A smaller last product, where an unstable state was reached, and the least.
const LESS: f64 = 1e-2;
const LEAST: f64 = 1e-9;

/// Newton steps after which no further round begins.
const MOST: usize = 1000;

/// What costs less energy than this part of what a swinging pipe is held by costs none: a buckled pipe
/// in a vertical hole may go round it.
const NEUTRAL: f64 = 1e-5;

/// Rounds of friction.
const ROUNDS: usize = 12;

/// Friction is settled when it changes by no more of its sum than this.
const SETTLED: f64 = 1e-3;

/// Torque and drag of one operation by the stiff string.
///
/// # Errors
/// Those of the [soft string](crate::statics::soft::solve), with which it begins, and an equilibrium
/// that was not found.
pub fn solve(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
) -> Result<StiffProfile, StiffError> {
    let equilibrium = equilibrium(model, operation, settings)?;
    Ok(StiffProfile::new(model, operation, &equilibrium))
}

pub(super) fn equilibrium(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
) -> Result<Equilibrium, StiffError> {
    let soft = soft::solve(model, operation, &SoftSettings::default())?;
    let sizing = match settings.element_length {
        ElementLength::Uniform(length_m) => Sizing::uniform(length_m),
        ElementLength::Auto(accuracy) => Sizing::auto(model, &[*operation], accuracy)?,
    };
    let mesh = Mesh::new(&model.string, &sizing.refined(settings.refinement));
    let string = StringInHole::new(model, operation, settings, &mesh, &soft);
    let mut equations = Equations::new(string.nodes.len());
    let mut iterations = 0;
    let mut state = State::centred(&string);
    let found = reach(&string, &mut state, &mut equations, Begins::Cold, &mut iterations);
    let found = match found {
        Some(found) if found.stable => Some(found),
        other => {
            let before = other.map(|found| (found, state.clone(), equations.hook_load_N));
            let found = descend(&string, &mut state, &mut equations, &mut iterations);
            found.or_else(|| {
                let (found, was, hook_load_N) = before?;
                (state, equations.hook_load_N) = (was, hook_load_N);
                Some(found)
            })
        }
    };
    if let Some(convergence) = found {
        let hook_load_N = equations.hook_load_N;
        return Ok(Equilibrium { mesh, string, state, hook_load_N, convergence });
    }
    let (index, residual_N) = residual(&string, &state, &mut equations);
    Err(StiffError::NotConverged { md_m: string.nodes[index].md_m, residual_N, iterations })
}

/// Leaves the nodes on the wall whose contact force is more of the mean weight than their room is of
/// their clearance.
fn touch(string: &StringInHole, state: &mut State) {
    let weight_N = string.weight_N() / string.nodes.len() as f64;
    for (index, node) in string.nodes.iter().enumerate() {
        let on = node.has_wall()
            && state.normal_N[index] * node.clearance_m > weight_N * state.slack_m[index];
        if !on {
            state.normal_N[index] = 0.0;
        }
    }
}

/// Interior point and active set; none where they reach no equilibrium.
fn reach(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
    begins: Begins,
    iterations: &mut usize,
) -> Option<Convergence> {
    let found = interior_point::iterate(string, state, equations, begins).ok()?;
    *iterations += found.count;
    if !found.converged {
        return None;
    }
    touch(string, state);
    finish(string, state, equations, iterations)
}

/// Minimises the energy first, friction and torque apart, and goes on from there; once more with the
/// friction that this has, until the state reached is stable. An unstable one is better than none.
fn descend(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
    iterations: &mut usize,
) -> Option<Convergence> {
    *state = State::centred(string);
    let mut barrier = Barrier::new(string, equations);
    barrier.disturb(state);
    let mut unstable = None;
    let [mut first, mut last] = [FIRST, LAST];
    for _ in 0..ROUNDS {
        let found = barrier.minimise(state, [first, last]);
        *iterations += found.count;
        if !found.converged {
            break;
        }
        let mut there = state.clone();
        match reach(string, &mut there, barrier.equations, Begins::Warm, iterations) {
            Some(found) if found.stable => {
                *state = there;
                return Some(found);
            }
            Some(found) => {
                unstable = Some((found, there, barrier.equations.hook_load_N));
                // The barrier itself held the string straight.
                last *= LESS;
            }
            None => {}
        }
        let rubs_alike = barrier.rub(state) < SETTLED;
        if *iterations > MOST || rubs_alike && (unstable.is_none() || last < LEAST) {
            break;
        }
        first = LATER * last;
    }
    let (found, there, hook_load_N) = unstable?;
    (*state, equations.hook_load_N) = (there, hook_load_N);
    Some(found)
}

/// Ends the contact exactly and looks at what was found; none where it is no equilibrium.
fn finish(
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
    let (_, residual_N) = residual(string, state, equations);
    let residual = residual_N / string.weight_N();
    Some(Convergence {
        elements: string.elements.len(),
        iterations: *iterations,
        residual,
        stable: is_stable(string, state, equations),
    })
    .filter(|_| residual < RESIDUAL)
}

/// The largest force out of balance, N, and its node.
fn residual(string: &StringInHole, state: &State, equations: &mut Equations) -> (usize, f64) {
    let torques_N_m = contact::torques_N_m(string, &state.normal_N);
    equations.assemble(string, state, Some(&torques_N_m));
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

/// Whether every small motion costs energy, the wall given way to where the string touches it.
fn is_stable(string: &StringInHole, state: &State, equations: &mut Equations) -> bool {
    let hook_load_N = equations.hook_load_N;
    equations.assemble(string, state, None);
    equations.hook_load_N = hook_load_N;
    for (index, node) in string.nodes.iter().enumerate() {
        if let Some(wall_N_per_m) = wall_N_per_m(node, state, index) {
            let mut across = equations.matrix.diagonal[index].fixed_view_mut::<2, 2>(0, 0);
            across += wall_N_per_m;
        }
    }
    equations.hold_across(NEUTRAL * string.swing_N_per_m());
    equations.matrix.is_positive_definite()
}

/// What the wall of a node that touches it holds small motions across the hole with, N/m: it gives
/// way along the normal, and around the hole its force turns with the node. None of another node.
pub(super) fn wall_N_per_m(node: &Node, state: &State, index: usize) -> Option<Matrix2<f64>> {
    let normal_N = state.normal_N[index];
    (normal_N > 0.0).then(|| {
        let (direction, radius_m) = direction(state, index);
        let radial = direction * direction.transpose();
        let (_, gives_m_per_N) = node.compliance.penetration_m(normal_N);
        radial / gives_m_per_N + (Matrix2::identity() - radial) * (normal_N / radius_m)
    })
}
