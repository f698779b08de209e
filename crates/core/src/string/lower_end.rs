//! The lower end of a string: as much of it as is in the hole.

use super::{ComponentLength, ComponentSpec, DrillString, NEAREST_BEND_M, StringSpec};
use crate::sizing::assembly_top_m;

/// Ends of components nearer to the surface than this are at it, m.
const AT_SURFACE_M: f64 = 1e-3;

impl StringSpec {
    /// The lowest components up to a length, m, with the bit at that depth, because a rig runs them
    /// from the bit up, and any part above the surface is not in the hole yet. The component at the
    /// surface is cut there; its bend, lateral force or survey sensor is left out where it would be
    /// above the surface. A string that is no longer than that, or that runs to the surface, is
    /// whole.
    #[must_use]
    pub fn lower_end(&self, length_m: f64) -> Self {
        let mut components = Vec::with_capacity(self.components.len());
        let mut below_m = 0.0;
        for component in &self.components {
            let left_m = length_m - below_m;
            if left_m <= AT_SURFACE_M && !components.is_empty() {
                break;
            }
            match component.length {
                ComponentLength::Metres(own_m) if own_m > left_m + AT_SURFACE_M => {
                    components.push(component.cut(left_m));
                    break;
                }
                ComponentLength::Metres(own_m) => below_m += own_m,
                ComponentLength::ToSurface => {}
            }
            components.push(component.clone());
        }
        Self { components }
    }
}

impl ComponentSpec {
    /// Its lower end of a length, m.
    fn cut(&self, length_m: f64) -> Self {
        let is_inside = |from_lower_end_m: f64| from_lower_end_m <= length_m - NEAREST_BEND_M;
        let blades = self.blades.map(|mut blades| {
            blades.length_m = blades.length_m.min(length_m);
            blades
        });
        Self {
            length: ComponentLength::Metres(length_m),
            blades,
            bend: self.bend.filter(|bend| is_inside(bend.from_lower_end_m)),
            lateral_force: self.lateral_force.filter(|force| is_inside(force.from_lower_end_m)),
            survey_sensor_m: self.survey_sensor_m.filter(|at_m| *at_m <= length_m),
            ..self.clone()
        }
    }
}

impl DrillString {
    /// Length of the bottom-hole assembly, m: from the bit to where ordinary drill pipe begins.
    /// None of a string without such pipe, or of pipe alone.
    pub fn assembly_length_m(&self) -> Option<f64> {
        Some(assembly_top_m(self)).filter(|length_m| *length_m > 0.0)
    }
}
