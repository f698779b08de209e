//! The model that every solver shares: one well, one string, one mud, one rig.

use serde::Serialize;

use crate::{GRAVITY_M_PER_S2, mud::Mud, rig::Rig, string::DrillString, well::Well};

/// Everything about the drill string and its surroundings that does not depend on what the driller
/// is doing. All solvers read the same one, so that their answers can be compared with each other.
#[derive(Debug, Clone, Serialize)]
pub struct Model {
    /// Path of the hole and its sections.
    pub well: Well,
    /// Components from the bit up; they fill the hole from the bit to the surface.
    pub string: DrillString,
    /// Drilling fluid, the same inside and outside the string.
    pub mud: Mud,
    /// Hoist and top drive.
    pub rig: Rig,
}

/// The mud at rest in the well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MudColumn {
    weight_N_per_m3: f64,
    surface_m: f64,
}

impl Model {
    /// A well, a string and a mud on a rig without limits: set [`Self::rig`] for those.
    pub fn new(well: Well, string: DrillString, mud: Mud) -> Self {
        Self { well, string, mud, rig: Rig::default() }
    }

    /// The mud at rest, its surface where measured depth begins.
    pub fn mud_column(&self) -> MudColumn {
        MudColumn {
            weight_N_per_m3: self.mud.density_kg_per_m3 * GRAVITY_M_PER_S2,
            surface_m: self.well.path.at(0.0).position_m.z,
        }
    }
}

impl MudColumn {
    /// Pressure at a true vertical depth, Pa; zero at the surface and above.
    pub fn pressure_Pa(&self, tvd_m: f64) -> f64 {
        self.weight_N_per_m3 * (tvd_m - self.surface_m).max(0.0)
    }
}
