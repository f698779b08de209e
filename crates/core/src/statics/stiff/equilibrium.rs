//! The string at rest, and how that was found.

use super::{state::State, string_in_hole::StringInHole};
use crate::rod::mesh::Mesh;

/// How the equilibrium was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// Elements.
    pub elements: usize,
    /// Newton steps of all stages.
    pub iterations: usize,
    /// Largest force on a node that is out of balance, as a part of the string's weight.
    pub residual: f64,
    /// Whether every small motion costs energy: friction and torque apart, the state is stable.
    pub stable: bool,
}

/// The string at rest.
#[derive(Debug, Clone)]
pub(super) struct Equilibrium {
    pub(super) mesh: Mesh,
    pub(super) string: StringInHole,
    pub(super) state: State,
    pub(super) hook_load_N: f64,
    pub(super) convergence: Convergence,
}
