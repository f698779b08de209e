//! Contact by the primal-dual active set: each node is on the wall or off it, Newton's step is
//! computed for that set, and the set is then updated.
//!
//! M. Hintermüller, K. Ito and K. Kunisch, *The primal-dual active set strategy as a semismooth
//! Newton method*, SIAM J. Optim. 13 (2003). It converges exactly, but only from nearby: see
//! `docs/src/theory/stiff-string.md`.

use super::{
    blocks::Singular,
    contact,
    equations::Equations,
    interior_point::{Iterated, SHIFT},
    on_wall::OnWall,
    state::State,
    string_in_hole::StringInHole,
};

/// Maximum number of iterations.
const MOST: usize = 40;

/// Longest step across the hole, m.
const LONGEST_M: f64 = 0.05;

/// The iterations end after a step shorter than the first length, m, or where the next step is
/// expected to be shorter than the second. Only whole steps count in which no node meets the wall
/// or leaves it.
const STILL_M: f64 = 1e-10;
const FORESEEN_M: f64 = 1e-12;

/// Iterates a state near equilibrium until it converges. The equations are left as those of the
/// final state.
pub(super) fn iterate(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
) -> Result<Iterated, Singular> {
    // Lengths of the last two steps, m, where only positions changed.
    let mut settled_m = [None::<f64>; 2];
    for count in 0..=MOST {
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        equations.assemble(string, state, Some(&torques_N_m));
        if is_still(settled_m) {
            return Ok(Iterated { count, converged: true });
        }
        if count == MOST {
            break;
        }
        equations.shift_across(SHIFT * string.foundation_N_per_m());
        let on_wall = OnWall::press(string, state, equations);
        equations.matrix.solve(&mut equations.force)?;
        let step = &equations.force;
        let longest_m =
            step.iter().map(|by| libm::hypot(libm::hypot(by[0], by[1]), by[2])).fold(0.0, f64::max);
        if !longest_m.is_finite() {
            return Ok(Iterated { count: count + 1, converged: false });
        }
        let part = (LONGEST_M / longest_m).min(1.0);
        equations.stretch(state, part);
        state.advance(step, part);
        let changed = on_wall.follow(string, state, step, part);
        let settles = changed == 0 && part == 1.0;
        settled_m = [settled_m[1], settles.then_some(longest_m)];
    }
    Ok(Iterated { count: MOST, converged: false })
}

/// Whether the lengths of the last two steps, m, show convergence: the error of Newton's method is
/// squared from step to step.
fn is_still(settled_m: [Option<f64>; 2]) -> bool {
    match settled_m {
        [_, Some(last_m)] if last_m < STILL_M => true,
        [Some(before_m), Some(last_m)] => last_m * (last_m / before_m).powi(2) < FORESEEN_M,
        _ => false,
    }
}
