//! The string at rest, and how that was found.

use serde::{Deserialize, Serialize};

use super::{StiffSettings, mesh_error::MeshError, state::State, string_in_hole::StringInHole};
use crate::{
    finite,
    rod::{buckled_element::BuckledElement, mesh::Mesh},
};

/// How the equilibrium was found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Convergence {
    /// Elements.
    pub elements: usize,
    /// Newton steps of all stages.
    pub iterations: usize,
    /// Largest force on a node that is out of balance, as a part of the string's weight.
    #[serde(with = "finite")]
    pub residual: f64,
    /// Whether every small motion costs energy: friction and torque apart, the state is stable.
    pub stable: bool,
    /// Of a state that would not stay, where the string rolls around its hole when it is let go,
    /// measured depth in m: it turns, and has no state of rest in which it is buckled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rolls_at_md_m: Option<f64>,
    /// What the elements' lengths leave uncertain where contacts begin and end; none where the
    /// lengths are given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh_error: Option<MeshError>,
    /// The element that is most beyond its own buckling load, where one is: the state holds only as
    /// long as nothing moves between its nodes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub buckled_element: Option<BuckledElement>,
}

/// The string at rest: what a neighbouring load, depth or friction begins with.
#[derive(Debug, Clone)]
pub struct Equilibrium {
    pub(super) settings: StiffSettings,
    pub(super) mesh: Mesh,
    pub(super) string: StringInHole,
    pub(super) state: State,
    pub(super) hook_load_N: f64,
    pub(super) convergence: Convergence,
}

impl Equilibrium {
    /// How it was found.
    pub fn convergence(&self) -> &Convergence {
        &self.convergence
    }
}
