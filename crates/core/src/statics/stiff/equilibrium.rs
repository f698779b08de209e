//! The string at rest, and how that was found.

use serde::{Deserialize, Serialize};

use super::{
    StiffError, StiffSettings, mesh_error::MeshError, state::State, string_in_hole::StringInHole,
};
use crate::{
    finite,
    model::Model,
    rod::{buckled_element::BuckledElement, mesh::Mesh},
};

/// Strings whose lengths differ by less have the same mesh, m.
const SAME_M: f64 = 1e-6;

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

impl Equilibrium {
    /// This state, with the element that its compression buckles most in its convergence.
    pub(super) fn with_buckled_element(mut self) -> Self {
        let md_m = |node: usize| self.string.nodes[node].md_m;
        let compression_N = |index: usize| -self.state.tension_N[index];
        self.convergence.buckled_element = BuckledElement::most(&self.mesh, md_m, compression_N);
        self
    }

    /// Whether a string has this one's mesh: that of its length, by the same settings.
    pub(super) fn is_like(&self, model: &Model, settings: &StiffSettings) -> bool {
        self.settings == *settings
            && (self.mesh.length_m() - model.string.length_m()).abs() < SAME_M
    }

    /// The deepest penetration of the wall, m, and its node; none where nothing touches.
    pub(super) fn deepest(&self) -> Option<(f64, usize)> {
        let touching = self.string.nodes.iter().zip(&self.state.normal_N).enumerate();
        touching
            .filter(|(_, (node, normal_N))| node.has_wall() && **normal_N > 0.0)
            .map(|(index, (node, normal_N))| (node.compliance.penetration_m(*normal_N).0, index))
            .max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// An error where the wall gives way farther than its law holds: by more than the mean clearance
    /// it is another hole.
    pub(super) fn within_its_hole(self) -> Result<Self, StiffError> {
        let Some((penetration_m, index)) = self.deepest() else { return Ok(self) };
        let clearance_m = self.string.mean_clearance_m();
        if penetration_m <= clearance_m {
            return Ok(self);
        }
        let md_m = self.string.nodes[index].md_m;
        Err(StiffError::ThroughWall { md_m, penetration_m, clearance_m })
    }
}
