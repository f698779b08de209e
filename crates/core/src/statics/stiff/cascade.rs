//! Search for the equilibrium, from the fastest method to the most robust one.

use super::{
    StiffError,
    equations::Equations,
    equilibrium::Convergence,
    interior_point::{self, Begins},
    judge::{finish, residual},
    relaxation::{Does, LOOKS, Relaxation},
    state::State,
    string_in_hole::StringInHole,
};

/// Why there is no equilibrium, and the tensions with which the search ended, N.
pub(super) struct NotFound {
    pub(super) error: StiffError,
    pub(super) tension_N: Vec<f64>,
}

/// Searches for the equilibrium from the middle of the hole, after `iterations` of other attempts.
pub(super) fn from_the_middle(
    string: &StringInHole,
    equations: &mut Equations,
    mut iterations: usize,
) -> Result<(Convergence, State), NotFound> {
    let mut state = State::centred(string);
    let found = reach(string, &mut state, equations, Begins::Cold, &mut iterations);
    if let Some(found) = found.filter(|found| found.stable) {
        return Ok((found, state));
    }
    // An unstable equilibrium is better than none.
    let straight = found.map(|found| Reached { found, state, hook_load_N: equations.hook_load_N });
    let_go(string, equations, straight, iterations)
}

/// Searches for the stable equilibrium next to a state.
pub(super) fn warm_start(
    string: &StringInHole,
    carried: State,
    equations: &mut Equations,
    iterations: &mut usize,
) -> Option<(Convergence, State)> {
    if let Some(settled) = settle(string, carried.clone(), equations, iterations) {
        return Some(settled);
    }
    let mut state = carried;
    state.leave_the_wall(string);
    let found = reach(string, &mut state, equations, Begins::Warm, iterations);
    Some((found.filter(|found| found.stable)?, state))
}

/// Searches for a stable equilibrium so near to a state that only the contacts have to be found.
pub(super) fn settle(
    string: &StringInHole,
    mut state: State,
    equations: &mut Equations,
    iterations: &mut usize,
) -> Option<(Convergence, State)> {
    let found = finish(string, &mut state, equations, iterations)?;
    found.stable.then_some((found, state))
}

/// Applies the interior point and then the active set; none where they reach no equilibrium.
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

/// Keeps those nodes on the wall whose ratio of contact force to mean weight exceeds the ratio of
/// their remaining gap to their clearance.
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

/// An equilibrium and its hook load.
struct Reached {
    found: Convergence,
    state: State,
    hook_load_N: f64,
}

/// Searches by dynamic relaxation alone.
pub(super) fn released(
    string: &StringInHole,
    equations: &mut Equations,
) -> Result<(Convergence, State), NotFound> {
    let_go(string, equations, None, 0)
}

/// Searches by dynamic relaxation: releases the string in the middle of its hole and takes the
/// state in which it reaches equilibrium, or `otherwise` where it does not.
fn let_go(
    string: &StringInHole,
    equations: &mut Equations,
    otherwise: Option<Reached>,
    mut iterations: usize,
) -> Result<(Convergence, State), NotFound> {
    let mut relaxation = Relaxation::begin(string);
    // An equilibrium held by friction, though by its energy alone it is unstable.
    let mut held = None;
    let mut does = Does::Rests;
    for _ in 0..LOOKS {
        let (mut moved, before) = (false, relaxation.steps);
        does = relaxation.go_on(equations, &mut moved);
        iterations += relaxation.steps - before;
        if moved {
            held = None;
        }
        if does != Does::Rests {
            break;
        }
        let mut state = relaxation.state.clone();
        if let Some(found) = finish(string, &mut state, equations, &mut iterations) {
            if found.stable {
                return Ok((found, state));
            }
            held = Some(Reached { found, state, hook_load_N: equations.hook_load_N });
        }
    }
    let rolls_at_md_m = match does {
        Does::Rolls(node) => Some(string.nodes[node].md_m),
        _ => None,
    };
    if let Some(Reached { found, state, hook_load_N }) = held.or(otherwise) {
        equations.hook_load_N = hook_load_N;
        return Ok((Convergence { iterations, rolls_at_md_m, ..found }, state));
    }
    let error = if let Some(md_m) = rolls_at_md_m {
        StiffError::Rolls { md_m, iterations }
    } else if let Does::RunsAway(element) = does {
        let compression_N = -relaxation.state.tension_N[element];
        StiffError::RunsAway { md_m: string.nodes[element].md_m, compression_N, iterations }
    } else {
        let (index, residual_N) = residual(string, &relaxation.state, equations);
        StiffError::NotConverged { md_m: string.nodes[index].md_m, residual_N, iterations }
    };
    Err(NotFound { error, tension_N: relaxation.state.tension_N })
}
