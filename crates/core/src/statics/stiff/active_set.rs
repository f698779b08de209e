//! Contact by the primal-dual active set: each node on the wall or off it, Newton's step for that,
//! and who is on the wall looked at again.
//!
//! M. Hintermüller, K. Ito and K. Kunisch, *The primal-dual active set strategy as a semismooth
//! Newton method*, SIAM J. Optim. 13 (2003). It ends exactly, but only from nearby: see
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

/// Iterations before it gives up.
const MOST: usize = 40;

/// Longest step across the hole, m.
const LONGEST_M: f64 = 0.05;

/// Steps shorter than this end it, m.
const STILL_M: f64 = 1e-10;

/// Brings a state that is near to equilibrium into it.
pub(super) fn iterate(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
) -> Result<Iterated, Singular> {
    for count in 1..=MOST {
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        equations.assemble(string, state, Some(&torques_N_m));
        equations.shift_across(SHIFT * string.foundation_N_per_m());
        let on_wall = OnWall::press(string, state, equations);
        equations.matrix.solve(&mut equations.force)?;
        let step = &equations.force;
        let longest_m = step.iter().map(|by| by[0].hypot(by[1]).hypot(by[2])).fold(0.0, f64::max);
        if !longest_m.is_finite() {
            return Ok(Iterated { count, converged: false });
        }
        let part = (LONGEST_M / longest_m).min(1.0);
        equations.stretch(state, part);
        state.advance(step, part);
        let changed = on_wall.follow(string, state, step, part);
        if changed == 0 && part == 1.0 && longest_m < STILL_M {
            return Ok(Iterated { count, converged: true });
        }
    }
    Ok(Iterated { count: MOST, converged: false })
}
