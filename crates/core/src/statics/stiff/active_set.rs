//! Contact by the primal-dual active set: each node on the wall or off it, Newton's step for that,
//! and who is on the wall looked at again.
//!
//! M. Hintermüller, K. Ito and K. Kunisch, *The primal-dual active set strategy as a semismooth
//! Newton method*, SIAM J. Optim. 13 (2003). It ends exactly, but only from nearby: see
//! `docs/src/theory/stiff-string.md`.

use nalgebra::Vector2;

use super::{
    blocks::Singular,
    contact::{self, Push},
    equations::Equations,
    interior_point::{Iterated, SHIFT},
    state::State,
    string_in_hole::StringInHole,
};

/// Iterations before it gives up.
const MOST: usize = 40;

/// Longest step across the hole, m.
const LONGEST_M: f64 = 0.05;

/// Steps shorter than this end it, m.
const STILL_M: f64 = 1e-10;

/// Contact force of a node that meets the wall, as a part of the mean weight of a node.
const FIRST: f64 = 0.1;

/// Part of its contact force that a node keeps which would be pulled, but is in the wall; below this
/// part of the mean weight it has none.
const LESS: f64 = 0.1;
const NOTHING: f64 = 1e-9;

/// What the wall of a node on it adds to a Newton step: its contact force changes by so much, and so
/// much for a metre of offset.
#[derive(Debug, Clone, Copy)]
struct Coupling {
    force_N: f64,
    by_offset: Vector2<f64>,
}

/// Brings a state that is near to equilibrium into it.
pub(super) fn iterate(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
) -> Result<Iterated, Singular> {
    let weight_N = string.weight_N() / string.nodes.len() as f64;
    let nodes = string.nodes.len();
    let mut couplings: Vec<Option<Coupling>> = vec![None; nodes];
    for count in 1..=MOST {
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        equations.assemble(string, state, Some(&torques_N_m));
        equations.shift_across(SHIFT * string.foundation_N_per_m());
        for (index, coupling) in couplings.iter_mut().enumerate() {
            *coupling =
                (state.normal_N[index] > 0.0).then(|| couple(string, state, equations, index));
        }
        equations.matrix.solve(&mut equations.force)?;
        let step = &equations.force;
        let longest_m = step.iter().map(|by| by[0].hypot(by[1]).hypot(by[2])).fold(0.0, f64::max);
        if !longest_m.is_finite() {
            return Ok(Iterated { count, converged: false });
        }
        let part = (LONGEST_M / longest_m).min(1.0);
        for index in 0..string.elements.len() {
            state.tension_N[index] += part * equations.tension_step_N(index, step);
        }
        state.advance(step, part);
        let mut changed = 0;
        for (index, node) in string.nodes.iter().enumerate().filter(|(_, n)| n.has_wall()) {
            match couplings[index] {
                Some(of) => {
                    let du = Vector2::new(step[index][0], step[index][1]);
                    let before_N = state.normal_N[index];
                    let after_N = before_N + part * (of.force_N + of.by_offset.dot(&du));
                    if after_N <= 0.0 {
                        // A wall that is soft at first: Newton's step from above goes too far.
                        let inside = state.offset_m[index].xy().norm() < node.clearance_m;
                        let leaves = inside || before_N < NOTHING * weight_N;
                        state.normal_N[index] = if leaves { 0.0 } else { LESS * before_N };
                        changed += 1;
                    } else {
                        state.normal_N[index] = after_N;
                    }
                }
                None => {
                    if state.offset_m[index].xy().norm() > node.clearance_m {
                        state.normal_N[index] = FIRST * weight_N;
                        changed += 1;
                    }
                }
            }
        }
        if changed == 0 && part == 1.0 && longest_m < STILL_M {
            return Ok(Iterated { count, converged: true });
        }
    }
    Ok(Iterated { count: MOST, converged: false })
}

/// Adds the wall of a node on it to the equations, its contact force condensed.
fn couple(
    string: &StringInHole,
    state: &State,
    equations: &mut Equations,
    index: usize,
) -> Coupling {
    let node = &string.nodes[index];
    let offset = state.offset_m[index].xy();
    let radius_m = offset.norm();
    let direction = offset / radius_m.max(f64::MIN_POSITIVE);
    let normal_N = state.normal_N[index];
    let (penetration_m, gives_m_per_N) = node.compliance.penetration_m(normal_N);
    let stiffness_N_per_m = 1.0 / gives_m_per_N;
    let coupling = Coupling {
        force_N: (radius_m - node.clearance_m - penetration_m) * stiffness_N_per_m,
        by_offset: direction * stiffness_N_per_m,
    };
    let push = Push::exact(node, &direction, radius_m);
    equations.press(index, &push, [normal_N, coupling.force_N], &coupling.by_offset);
    coupling
}
