//! One component of the string: a bit, a motor, a stand of collars, all the drill pipe.

use std::f64::consts::PI;

use serde::Serialize;

use super::{
    BodyBend, ConnectionStrength, Eccentricity, LateralForce, Material, catalogue::PipeClass,
};
use crate::{GRAVITY_M_PER_S2, mud::Densities};

/// Tool joints: the thick, short ends of a pipe, the only part of it that usually touches the wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ToolJoints {
    /// Outside diameter of the joint, m.
    pub od_m: f64,
    /// Distance between joints along the string, m.
    pub spacing_m: f64,
}

/// Blades of a stabiliser, a reamer, a centraliser: a short, wider stretch at the middle of its
/// component, and the only part of it that usually touches the wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Blades {
    /// Diameter over the blades, m: the gauge.
    pub od_m: f64,
    /// Length along the string, m.
    pub length_m: f64,
}

/// A uniform stretch of the string.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Component {
    /// Name given by the user.
    pub name: String,
    /// Length, m.
    pub length_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter of the body, m.
    pub id_m: f64,
    /// Mass per length in air, kg/m, tool joints included.
    pub mass_per_length_kg_per_m: f64,
    /// Tool joints, if it has any. Without them the contact radius is `od_m / 2`.
    pub joints: Option<ToolJoints>,
    /// Blades, if it has any: instead of joints.
    pub blades: Option<Blades>,
    /// Material.
    pub material: Material,
    /// Minimum yield strength, Pa, where known.
    pub yield_strength_Pa: Option<f64>,
    /// Wear class of its body: [`Self::od_m`] is the remaining diameter.
    #[serde(skip_serializing_if = "PipeClass::is_new")]
    pub class: PipeClass,
    /// Strength of its connections.
    #[serde(skip_serializing_if = "ConnectionStrength::is_unknown")]
    pub connection: ConnectionStrength,
    /// A bend of its body.
    pub bend: Option<BodyBend>,
    /// Steel off the axis.
    pub eccentricity: Option<Eccentricity>,
    /// Distance of its survey sensor from the lower end, m, if it holds one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub survey_sensor_m: Option<f64>,
    /// A force across it.
    pub lateral_force: Option<LateralForce>,
}

/// Yield strength in shear over that in tension: 0.096167 of API RP 7G's `Q = 0.096167 J Y/D` is a
/// sixth of it, by `2/D` for the outer radius and 12 inches to a foot.
const SHEAR_PER_TENSILE_YIELD: f64 = 6.0 * 0.096167;

/// Area of a ring, m².
pub(super) fn ring_area_m2(od_m: f64, id_m: f64) -> f64 {
    PI / 4.0 * (od_m * od_m - id_m * id_m)
}

impl Component {
    /// Plain pipe: no joints, its mass that of the ring between `id_m` and `od_m`.
    pub fn uniform(
        name: impl Into<String>,
        od_m: f64,
        id_m: f64,
        length_m: f64,
        material: Material,
    ) -> Self {
        Self {
            name: name.into(),
            length_m,
            od_m,
            id_m,
            mass_per_length_kg_per_m: material.density_kg_per_m3 * ring_area_m2(od_m, id_m),
            joints: None,
            blades: None,
            material,
            yield_strength_Pa: None,
            class: PipeClass::New,
            connection: ConnectionStrength::default(),
            bend: None,
            eccentricity: None,
            survey_sensor_m: None,
            lateral_force: None,
        }
    }

    /// Area of the body's metal, `A = π/4 (D² - d²)`, m².
    pub fn area_m2(&self) -> f64 {
        ring_area_m2(self.od_m, self.id_m)
    }

    /// Area of the bore, m².
    pub fn inner_area_m2(&self) -> f64 {
        ring_area_m2(self.id_m, 0.0)
    }

    /// Second moment of area of the body, `I = π/64 (D⁴ - d⁴)`, m⁴.
    pub fn second_moment_m4(&self) -> f64 {
        PI / 64.0 * (self.od_m.powi(4) - self.id_m.powi(4))
    }

    /// Polar second moment of area of the body, `J = 2 I`, m⁴.
    pub fn polar_moment_m4(&self) -> f64 {
        2.0 * self.second_moment_m4()
    }

    /// Axial stiffness `EA` of the body, N. Tool joints are not counted: a joint of 5 % of the
    /// length makes a pipe about 3 % stiffer.
    pub fn axial_stiffness_N(&self) -> f64 {
        self.material.youngs_modulus_Pa * self.area_m2()
    }

    /// Bending stiffness `EI` of the body, N·m².
    pub fn bending_stiffness_N_m2(&self) -> f64 {
        self.material.youngs_modulus_Pa * self.second_moment_m4()
    }

    /// Torsional stiffness `GJ` of the body, N·m².
    pub fn torsional_stiffness_N_m2(&self) -> f64 {
        self.material.shear_modulus_Pa * self.polar_moment_m4()
    }

    /// Whether the component is a bit: the last word of its name is "bit".
    pub fn is_bit(&self) -> bool {
        self.name
            .split(|c: char| !c.is_alphanumeric())
            .rfind(|word| !word.is_empty())
            .is_some_and(|word| word.eq_ignore_ascii_case("bit"))
    }

    /// Radius on which the component touches the wall, m: that of the blades or of the joints where
    /// it has either, the body's otherwise.
    pub fn contact_radius_m(&self) -> f64 {
        let joints = self.joints.map(|joints| joints.od_m);
        let blades = self.blades.map(|blades| blades.od_m);
        blades.or(joints).unwrap_or(self.od_m) / 2.0
    }

    /// Weight per length in mud inside and outside, `m g (1 - ρ_mud/ρ_metal)`, N/m.
    ///
    /// Negative where the mud is denser than the metal.
    pub fn buoyed_weight_per_length_N_per_m(&self, mud_density_kg_per_m3: f64) -> f64 {
        self.mass_per_length_kg_per_m
            * GRAVITY_M_PER_S2
            * (1.0 - mud_density_kg_per_m3 / self.material.density_kg_per_m3)
    }

    /// Weight per length that effective tension balances, N/m, with different fluids inside and
    /// outside: `g (m + ρ_i A_i − ρ_o (A_i + V))` with `V` the volume of the metal per length, tool
    /// joints included. Archimedes' for the same fluid on both sides.
    pub fn weight_in_N_per_m(&self, densities: Densities) -> f64 {
        self.buoyed_weight_per_length_N_per_m(densities.annulus_kg_per_m3)
            + GRAVITY_M_PER_S2 * densities.excess_kg_per_m(self.inner_area_m2())
    }

    /// Tension at which the body yields, `P = A Y`, N (API RP 7G); `None` where the yield strength
    /// is not known.
    pub fn tensile_yield_N(&self) -> Option<f64> {
        Some(self.area_m2() * self.yield_strength_Pa?)
    }

    /// Torque at which the body's surface yields, N·m; `None` where the yield strength is not
    /// known.
    ///
    /// `Q = 2 J (0.577 Y) / D`: the shear stress at the surface reaches von Mises' `Y/√3`, with the
    /// constant of API RP 7G, in inches, psi and ft·lbf `0.096167 J Y / D`, 0.06 % below `1/√3`.
    pub fn torsional_yield_N_m(&self) -> Option<f64> {
        let shear_yield_Pa = SHEAR_PER_TENSILE_YIELD * self.yield_strength_Pa?;
        Some(2.0 * self.polar_moment_m4() * shear_yield_Pa / self.od_m)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bit_is_known_by_the_last_word_of_its_name() {
        let steel = Material::STEEL;
        let is_bit = |name: &str| Component::uniform(name, 0.2159, 0.06, 0.3, steel).is_bit();
        for name in ["bit", "Bit", "PDC bit", "8-1/2 in bit (bit)", "core-bit"] {
            assert!(is_bit(name), "{name}");
        }
        for name in ["bit sub", "near-bit stabiliser", "motor", "orbit", ""] {
            assert!(!is_bit(name), "{name}");
        }
    }
}
