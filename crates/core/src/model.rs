//! The model that every solver shares: one well, one string, one mud, one rig.

use serde::Serialize;

use crate::{
    GRAVITY_M_PER_S2,
    ends::{BitEnd, Ends},
    mud::Mud,
    rig::Rig,
    statics::buckling::Criterion,
    string::DrillString,
    well::Well,
};

/// Everything about the drill string and its surroundings that does not depend on what the driller
/// is doing. All solvers read the same one, so that their results can be compared with each other.
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
    /// Lateral constraints of the string's ends. The soft string does not use them.
    pub ends: Ends,
    /// Whose buckling loads compression is compared with.
    pub buckling: Criterion,
}

/// A bit with less clearance than this fills its hole, m: contact and friction of its body would be
/// those of a pipe that whirls in half a millimetre.
const SNUG_M: f64 = 2e-3;

/// Length of a bit over its diameter, at most: as much is held of a string that names no bit.
const BIT_DIAMETERS: f64 = 2.0;

/// The mud at rest in the well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MudColumn {
    weight_N_per_m3: f64,
    surface_m: f64,
}

impl Model {
    /// A well, a string and a mud on a rig without limits, its ends as they usually are: set
    /// [`Self::rig`] and [`Self::ends`] for others.
    pub fn new(well: Well, string: DrillString, mud: Mud) -> Self {
        Self {
            well,
            string,
            mud,
            rig: Rig::default(),
            ends: Ends::default(),
            buckling: Criterion::default(),
        }
    }

    /// The mud at rest, its surface where measured depth begins.
    pub fn mud_column(&self) -> MudColumn {
        MudColumn {
            weight_N_per_m3: self.mud.density_kg_per_m3 * GRAVITY_M_PER_S2,
            surface_m: self.well.path.at(0.0).position_m.z,
        }
    }

    /// Length of the lower end that is held to the hole's axis instead of touching the wall, m.
    ///
    /// The lowest node always is. Where the first component fills the drilled hole, all of it is if
    /// it is a [bit](crate::string::Component::is_bit); of a motor or a collar without a bit no
    /// more than a bit's length, for its body is pressed against the wall like any other. Of a free
    /// end nothing is.
    pub(crate) fn held_length_m(&self) -> f64 {
        if self.ends.bit == BitEnd::Free {
            return 0.0;
        }
        let lowest = &self.string.components()[0];
        let drilled = 0.5 * self.well.hole.at(self.string.length_m()).diameter_m;
        if drilled - 0.5 * lowest.od_m >= SNUG_M {
            return f64::MIN_POSITIVE;
        }
        if lowest.is_bit() {
            lowest.length_m
        } else {
            lowest.length_m.min(BIT_DIAMETERS * lowest.od_m)
        }
    }
}

impl MudColumn {
    /// Pressure at a true vertical depth, Pa; zero at the surface and above.
    pub fn pressure_Pa(&self, tvd_m: f64) -> f64 {
        self.weight_N_per_m3 * (tvd_m - self.surface_m).max(0.0)
    }
}
