//! The string at rest, and the convergence of its solution.

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

/// Convergence of an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Convergence {
    /// Number of elements.
    pub elements: usize,
    /// Newton steps of all stages.
    pub iterations: usize,
    /// Largest force on a node that is out of balance, as a part of the string's weight.
    #[serde(with = "finite")]
    pub residual: f64,
    /// Whether every small motion costs energy: friction and torque apart, the state is stable.
    pub stable: bool,
    /// For an unstable state, measured depth at which the released string rolls around its hole, m:
    /// it rotates, and has no static equilibrium in which it is buckled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rolls_at_md_m: Option<f64>,
    /// Discretisation error where contacts begin and end; none where the lengths of the elements
    /// are given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh_error: Option<MeshError>,
    /// The same on a finer mesh, of a string that is pushed down as a helix; `None` of others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub finer_helix: Option<FinerHelix>,
    /// The element that exceeds its own buckling load most, where one does: the state is valid only
    /// as long as nothing moves between its nodes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub buckled_element: Option<BuckledElement>,
}

/// A string that is pushed down as a helix, on a mesh with elements half as long where it is
/// compressed. Friction feeds on the wall load of the helix, and that on the compression: near
/// lock-up two meshes may have helices of other lengths, and other hook loads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FinerHelix {
    /// Hook load without block, N; `None` where no equilibrium was found.
    pub hook_load_N: Option<f64>,
}

/// The string at rest, with which the solution of a neighbouring load, depth or friction can begin.
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
    /// Convergence of its solution.
    pub fn convergence(&self) -> &Convergence {
        &self.convergence
    }
}

impl Equilibrium {
    /// The same, with the element that exceeds its own buckling load most in its convergence.
    pub(super) fn with_buckled_element(mut self) -> Self {
        let md_m = |node: usize| self.string.nodes[node].md_m;
        let compression_N = |index: usize| -self.state.tension_N[index];
        self.convergence.buckled_element = BuckledElement::most(&self.mesh, md_m, compression_N);
        self
    }

    /// The elements whose compression exceeds a load, N, which is given by measured depth, m.
    pub(super) fn compressed_beyond(&self, load_N: impl Fn(f64) -> Option<f64>) -> Vec<bool> {
        let beyond = |index: usize| {
            let load_N = load_N(self.string.nodes[index].md_m);
            load_N.is_some_and(|load_N| -self.state.tension_N[index] > load_N)
        };
        (0..self.mesh.elements.len()).map(beyond).collect()
    }

    /// Whether a string can use this one's mesh: it has the same length and settings.
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

    /// Returns an error where the penetration of the wall exceeds the mean clearance of the string,
    /// beyond which its contact law is not valid.
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
