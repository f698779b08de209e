//! How the equilibrium is looked for, from the fastest way to the surest.

use super::{
    StiffError,
    barrier::Barrier,
    equations::Equations,
    equilibrium::Convergence,
    interior_point::{self, Begins},
    judge::{finish, residual},
    state::State,
    string_in_hole::StringInHole,
};

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

/// Rounds of friction.
const ROUNDS: usize = 12;

/// Friction is settled when it changes by no more of its sum than this.
const SETTLED: f64 = 1e-3;

/// Part of the friction that is added first, and the least.
const FIRST_PART: f64 = 0.25;
const LEAST_PART: f64 = 0.01;

/// The equilibrium that is found from the middle of the hole, after so many iterations elsewhere.
/// `locks_up` says, where it is asked, whether there can be none.
pub(super) fn from_the_middle(
    string: &StringInHole,
    equations: &mut Equations,
    mut iterations: usize,
    locks_up: impl FnOnce() -> Result<(), StiffError>,
) -> Result<(Convergence, State), StiffError> {
    let mut state = State::centred(string);
    let found = reach(string, &mut state, equations, Begins::Cold, &mut iterations);
    let straight = match found {
        Some(found) if found.stable => return Ok((found, state)),
        other => other.map(|found| (found, state.clone(), equations.hook_load_N)),
    };
    locks_up()?;
    if let Some(found) = descend(string, &mut state, equations, &mut iterations) {
        return Ok((found, state));
    }
    if let Some((found, was, hook_load_N)) = straight {
        equations.hook_load_N = hook_load_N;
        return Ok((found, was));
    }
    follow(string, equations, &mut iterations)
}

/// The stable equilibrium next to a state.
pub(super) fn warm_start(
    string: &StringInHole,
    carried: State,
    equations: &mut Equations,
    iterations: &mut usize,
) -> Option<(Convergence, State)> {
    let mut state = carried.clone();
    let found = finish(string, &mut state, equations, iterations);
    if let Some(found) = found.filter(|found| found.stable) {
        return Some((found, state));
    }
    state = carried;
    state.leave_the_wall(string);
    let found = reach(string, &mut state, equations, Begins::Warm, iterations);
    Some((found.filter(|found| found.stable)?, state))
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

/// Follows a stable equilibrium along its friction, from none to all of it.
fn follow(
    string: &StringInHole,
    equations: &mut Equations,
    iterations: &mut usize,
) -> Result<(Convergence, State), StiffError> {
    let smooth = string.rubbed_by(0.0);
    let mut state = State::centred(&smooth);
    let found = descend(&smooth, &mut state, equations, iterations);
    if !found.is_some_and(|found| found.stable) {
        let (index, residual_N) = residual(string, &state, equations);
        let md_m = string.nodes[index].md_m;
        return Err(StiffError::NotConverged { md_m, residual_N, iterations: *iterations });
    }
    let (mut part, mut step) = (0.0_f64, FIRST_PART);
    while step > LEAST_PART {
        let next = (part + step).min(1.0);
        let rougher = string.rubbed_by(next);
        match warm_start(&rougher, state.clone(), equations, iterations) {
            Some((found, there)) if next == 1.0 => return Ok((found, there)),
            Some((_, there)) => (part, state) = (next, there),
            None => step *= 0.5,
        }
    }
    Err(StiffError::Lost { part, iterations: *iterations })
}
