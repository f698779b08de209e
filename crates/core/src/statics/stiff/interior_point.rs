//! Contact by an interior point: every node is inside its hole, pushed off the wall by a force that
//! is inverse to the remaining gap, until `N s` vanishes.
//!
//! With `u` the offset from the axis, `c` the clearance and `α(N)` the penetration of the wall,
//!
//! ```text
//! s = (c² − |u|²)/(2c) + α(N) > 0,    N > 0,    N s = μ → 0
//! ```
//!
//! The constraint is smooth on the axis, where the pipe's side of the hole is not known
//! yet: the string begins there. J. Nocedal and S. J. Wright, *Numerical Optimization*, chapter 19.

use nalgebra::Vector2;

use super::{
    blocks::Singular,
    contact::{self, Push},
    equations::Equations,
    state::State,
    string_in_hole::StringInHole,
};

/// Maximum number of iterations.
const MOST: usize = 60;

/// Part of the way to the wall that a step may take.
const TO_THE_WALL: f64 = 0.995;

/// The parameter `μ` begins at this part of the mean of `N s`.
const FIRST: f64 = 0.1;

/// Product of force and gap at which the active set takes over, as a part of the mean weight of a
/// node times the clearance.
const FLOOR: f64 = 1e-7;

/// Shift of the matrix in a step, as a part of the stiffness of the foundation by weight.
pub(super) const SHIFT: f64 = 1e-4;

/// The iterations end after a step shorter than this, m.
const STILL_M: f64 = 1e-6;

/// Result of the iterations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Iterated {
    /// Number of iterations.
    pub(super) count: usize,
    /// Whether they converged.
    pub(super) converged: bool,
}

/// Condensed wall of a node in a Newton step.
#[derive(Debug, Clone, Copy, Default)]
struct Coupling {
    /// Change of the contact force: a constant part, and a part per metre of offset.
    force_N: f64,
    by_offset: Vector2<f64>,
    /// Difference between the definition of the gap and its present value, m.
    lacking_m: f64,
    /// Gradient of the gap by offset, and penetration per newton, m.
    towards: Vector2<f64>,
    gives_m_per_N: f64,
}

/// Initial state of the interior point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Begins {
    /// From the axis.
    Cold,
    /// From a state whose contact forces and gaps belong together.
    Warm,
}

/// Iterates a state until it is near equilibrium.
pub(super) fn iterate(
    string: &StringInHole,
    state: &mut State,
    equations: &mut Equations,
    begins: Begins,
) -> Result<Iterated, Singular> {
    let walled: Vec<usize> =
        (0..string.nodes.len()).filter(|index| string.nodes[*index].has_wall()).collect();
    let mean_clearance_m = walled.iter().map(|index| string.nodes[*index].clearance_m).sum::<f64>()
        / walled.len().max(1) as f64;
    let weight_N = string.weight_N() / string.nodes.len() as f64;
    let floor = FLOOR * weight_N * mean_clearance_m;
    if begins == Begins::Cold {
        for index in &walled {
            state.normal_N[*index] = state.normal_N[*index].max(0.1 * weight_N);
        }
    }
    let mean = |state: &State| {
        let sum: f64 = walled.iter().map(|i| state.normal_N[*i] * state.slack_m[*i]).sum();
        sum / walled.len().max(1) as f64
    };
    let mut product = match begins {
        Begins::Cold => FIRST * mean(state),
        Begins::Warm => mean(state),
    };
    let mut couplings = vec![Coupling::default(); string.nodes.len()];
    for count in 1..=MOST {
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        equations.assemble(string, state, Some(&torques_N_m));
        equations.shift_across(SHIFT * string.foundation_N_per_m());
        for index in &walled {
            couplings[*index] = couple(string, state, equations, *index, product);
        }
        equations.matrix.solve(&mut equations.force)?;
        let step = &equations.force;
        let (mut room, mut force) = (1.0_f64, 1.0_f64);
        let mut changes = Vec::with_capacity(walled.len());
        for index in &walled {
            let coupling = &couplings[*index];
            let du = Vector2::new(step[*index][0], step[*index][1]);
            let dn = coupling.force_N + coupling.by_offset.dot(&du);
            let ds = coupling.lacking_m + coupling.towards.dot(&du) + coupling.gives_m_per_N * dn;
            if ds < 0.0 {
                room = room.min(-TO_THE_WALL * state.slack_m[*index] / ds);
            }
            if dn < 0.0 {
                force = force.min(-TO_THE_WALL * state.normal_N[*index] / dn);
            }
            changes.push((*index, dn, ds));
        }
        // Friction couples forces and positions: one step length for both.
        let part = room.min(force);
        for (index, dn, ds) in changes {
            state.normal_N[index] += part * dn;
            state.slack_m[index] += part * ds;
        }
        equations.stretch(state, part);
        state.advance(step, part);
        let longest_m =
            step.iter().map(|by| libm::hypot(libm::hypot(by[0], by[1]), by[2])).fold(0.0, f64::max);
        if !longest_m.is_finite() {
            return Ok(Iterated { count, converged: false });
        }
        if product <= floor && part > 0.9 && longest_m < STILL_M {
            return Ok(Iterated { count, converged: true });
        }
        let falls = match part {
            _ if part > 0.9 => 0.02,
            _ if part > 0.5 => 0.1,
            _ if part > 0.2 => 0.4,
            _ => 0.8,
        };
        product = (falls * mean(state)).max(0.5 * floor);
    }
    Ok(Iterated { count: MOST, converged: false })
}

/// Adds the wall of a node to the equations, its contact force and its gap condensed.
fn couple(
    string: &StringInHole,
    state: &State,
    equations: &mut Equations,
    index: usize,
    product: f64,
) -> Coupling {
    let node = &string.nodes[index];
    let offset = state.offset_m[index].xy();
    let (normal_N, room_m) = (state.normal_N[index], state.slack_m[index]);
    let clearance_m = node.clearance_m;
    let (penetration_m, gives_m_per_N) = node.compliance.penetration_m(normal_N);
    let gap_m = (clearance_m * clearance_m - offset.norm_squared()) / (2.0 * clearance_m);
    let lacking_m = gap_m + penetration_m - room_m;
    let towards = -offset / clearance_m;
    let steep = normal_N / room_m;
    let over = 1.0 / (1.0 + steep * gives_m_per_N);
    let coupling = Coupling {
        force_N: (product / room_m - normal_N - steep * lacking_m) * over,
        by_offset: towards * (-steep * over),
        lacking_m,
        towards,
        gives_m_per_N,
    };
    let push = Push::smooth(node, &offset);
    equations.press(index, &push, [normal_N, coupling.force_N], &coupling.by_offset);
    coupling
}
