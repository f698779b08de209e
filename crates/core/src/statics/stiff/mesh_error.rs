//! Discretisation error of the elements.

use serde::{Deserialize, Serialize};

use crate::finite;

/// Discretisation error of the elements, estimated from the last two meshes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct MeshError {
    /// Hook load, N.
    #[serde(with = "finite")]
    pub hook_load_N: f64,
    /// Surface torque, N·m.
    #[serde(with = "finite")]
    pub surface_torque_N_m: f64,
    /// Sum of the contact forces, N.
    #[serde(with = "finite")]
    pub side_force_total_N: f64,
    /// Bending moment at a node, N·m: the largest change.
    #[serde(with = "finite")]
    pub bending_moment_N_m: f64,
    /// Measured depth of that change, m.
    #[serde(with = "finite")]
    pub md_m: f64,
}
