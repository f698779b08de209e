//! The scalars that every solver answers with, and how profiles along the string are read for them.

mod hole_wear;
mod profile;

pub use hole_wear::HOLE_STEP_M;
pub(crate) use hole_wear::{hole_depths_m, hole_steps, spread};
pub(crate) use profile::{SLACK, neutral_point_among};
pub use profile::{cutoff_depth_m, cutoff_in_build_m, neutral_point_m};

use serde::Serialize;

/// The models that answer with [`Scalars`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum ModelKind {
    /// Soft string: statics without bending stiffness.
    Soft,
    /// Dynamics of the whole string in time.
    Dynamic,
}

impl ModelKind {
    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Soft => "soft",
            Self::Dynamic => "dynamic",
        }
    }
}

/// Torque and drag of one operation: the quantities that every solver reports under the same names,
/// so that their answers can be compared. A dynamic solver reports means over its window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scalars {
    /// Tension at the top of the string, N; block and top drive excluded.
    pub hook_load_N: f64,
    /// Torque at the top of the string, N·m.
    pub surface_torque_N_m: f64,
    /// Part of the surface torque that comes from wall contact alone, N·m.
    pub friction_torque_N_m: f64,
    /// Wall friction along the string, N; positive adds to hook load.
    pub axial_friction_N: f64,
    /// Integral of the magnitude of the side force, N.
    pub side_force_total_N: f64,
    /// Weight on bit as solved, N.
    pub weight_on_bit_N: f64,
    /// Bit torque as solved, N·m.
    pub bit_torque_N_m: f64,
    /// Turn of the top against the bit, rad, positive when the top leads.
    pub twist_rad: f64,
    /// Elongation against the unloaded string, m.
    pub stretch_m: f64,
    /// Measured depth of the shallowest zero of effective tension, m.
    pub neutral_point_m: Option<f64>,
    /// Deepest change from high-side to low-side contact between the kick-off and 30 m below the
    /// build, m.
    pub cutoff_depth_m: Option<f64>,
}
