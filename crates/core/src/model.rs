//! The model that every solver shares: one well, one string, one mud, one rig.

use serde::Serialize;

use crate::{
    ends::{BitEnd, Ends},
    mud::{Densities, Fluids, Mud, MudColumn},
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
    /// Drilling fluid, inside and outside the string.
    pub mud: Mud,
    /// Fluids that replace it in parts of the well; the properties of drag across the hole are the
    /// mud's everywhere.
    #[serde(skip_serializing_if = "Fluids::is_empty")]
    pub fluids: Fluids,
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

impl Model {
    /// A well, a string and a mud on a rig without limits, its ends as they usually are: set
    /// [`Self::rig`] and [`Self::ends`] for others, and
    /// [`Self::fluids`] where the mud does not fill the well.
    pub fn new(well: Well, string: DrillString, mud: Mud) -> Self {
        Self {
            well,
            string,
            mud,
            fluids: Fluids::default(),
            rig: Rig::default(),
            ends: Ends::default(),
            buckling: Criterion::default(),
        }
    }

    /// The fluids at rest, their surface where measured depth begins.
    pub fn mud_column(&self) -> MudColumn {
        MudColumn::new(&self.mud, &self.fluids, &self.well.path)
    }

    /// Densities inside and outside the string at a measured depth, m.
    pub fn densities_at(&self, md_m: f64) -> Densities {
        Densities {
            inside_kg_per_m3: self.fluids.inside_at(&self.mud, md_m).density_kg_per_m3,
            annulus_kg_per_m3: self.fluids.annulus_at(&self.mud, md_m).density_kg_per_m3,
        }
    }

    /// Whether any fluid in the well has a rheology.
    pub fn has_rheology(&self) -> bool {
        self.fluids.has_rheology(&self.mud)
    }

    /// Sum of the magnitudes of the buoyed weights of all components, N.
    pub fn buoyed_weight_N(&self) -> f64 {
        let column = self.mud_column();
        let bit_depth_m = self.string.length_m();
        let weights = self.string.spans().map(|span| {
            let mds_m = [bit_depth_m - span.to_bit_m, bit_depth_m - span.from_bit_m];
            let weight_N_per_m = span.component.weight_in_N_per_m(column.mean_densities(mds_m));
            weight_N_per_m.abs() * span.component.length_m
        });
        weights.sum()
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
