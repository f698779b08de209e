//! Contact by the primal-dual active set: each node is on the wall or off it, Newton's step is
//! computed for that set, and the set is then updated.
//!
//! M. Hintermüller, K. Ito and K. Kunisch, *The primal-dual active set strategy as a semismooth
//! Newton method*, SIAM J. Optim. 13 (2003). It converges exactly, but only from nearby: see
//! `docs/src/theory/stiff-string.md`.

use nalgebra::Vector2;

use super::{
    blocks::{Entry, Singular},
    contact::{self, Push},
    equations::Equations,
    interior_point::{Iterated, SHIFT},
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

// The nodes on the wall and off it in a Newton step: those on it press, and the set of them is
// updated after the step.

/// Contact force of a node that meets the wall, as a part of the mean weight of a node.
const FIRST: f64 = 0.1;

/// Part of its contact force that a node in the wall keeps where the step would make the force
/// negative; below the second part of the mean weight the node has no force.
const LESS: f64 = 0.1;
const NOTHING: f64 = 1e-9;

/// Change of a node's contact force in a Newton step: a constant part, and a part per metre of
/// offset.
#[derive(Debug, Clone, Copy)]
struct Coupling {
    force_N: f64,
    by_offset: Vector2<f64>,
}

/// The walls of all nodes in a Newton step.
#[derive(Debug)]
pub(super) struct OnWall {
    couplings: Vec<Option<Coupling>>,
}

impl OnWall {
    /// Adds the walls of the nodes on them to the equations, their contact forces condensed.
    pub(super) fn press(string: &StringInHole, state: &State, equations: &mut Equations) -> Self {
        let couplings = (0..string.nodes.len()).map(|index| {
            (state.normal_N[index] > 0.0).then(|| couple(string, state, equations, index))
        });
        Self { couplings: couplings.collect() }
    }

    /// Applies a part of the step, by which the nodes have already moved, to the contact forces.
    /// Returns the number of nodes that meet the wall or leave it.
    pub(super) fn follow(
        &self,
        string: &StringInHole,
        state: &mut State,
        step: &[Entry],
        part: f64,
    ) -> usize {
        let weight_N = string.weight_N() / string.nodes.len() as f64;
        let mut changed = 0;
        for (index, node) in string.nodes.iter().enumerate().filter(|(_, n)| n.has_wall()) {
            let inside = state.offset_m[index].xy().norm() < node.clearance_m;
            let normal_N = &mut state.normal_N[index];
            match self.couplings[index] {
                Some(coupling) => {
                    let du = Vector2::new(step[index][0], step[index][1]);
                    let change_N = coupling.force_N + coupling.by_offset.dot(&du);
                    let after_N = *normal_N + part * change_N;
                    if after_N <= 0.0 {
                        // The wall is soft at first, so that Newton's step from above is too long.
                        let leaves = inside || *normal_N < NOTHING * weight_N;
                        *normal_N = if leaves { 0.0 } else { LESS * *normal_N };
                        changed += 1;
                    } else {
                        *normal_N = after_N;
                    }
                }
                None if !inside => {
                    *normal_N = FIRST * weight_N;
                    changed += 1;
                }
                None => {}
            }
        }
        changed
    }
}

/// Adds the wall of a node on it to the equations.
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
