//! The metal of a component.

use serde::Serialize;

/// Elastic and inertial properties of a component's metal.
///
/// `E` and `G` are independent inputs: published models do not always keep them consistent.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Material {
    /// Density, kg/m³.
    pub density_kg_per_m3: f64,
    /// Young's modulus, Pa.
    pub youngs_modulus_Pa: f64,
    /// Shear modulus, Pa.
    pub shear_modulus_Pa: f64,
    /// Coefficient of linear thermal expansion, 1/K.
    #[serde(skip_serializing_if = "expands_as_steel")]
    pub thermal_expansion_per_K: f64,
}

/// Coefficient of linear thermal expansion of steel, 1/K: 6.9e-6 per °F of A. Lubinski, W. S.
/// Althouse and J. L. Logan, *Helical Buckling of Tubing Sealed in Packers* (1962).
pub const STEEL_EXPANSION_PER_K: f64 = 1.8 * 6.9e-6;

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn expands_as_steel(per_K: &f64) -> bool {
    *per_K == STEEL_EXPANSION_PER_K
}

impl Material {
    /// Steel of drill pipe by default: 7860 kg/m³, 210 GPa, 76.923 GPa and
    /// [`STEEL_EXPANSION_PER_K`].
    pub const STEEL: Self = Self {
        density_kg_per_m3: 7860.0,
        youngs_modulus_Pa: 210e9,
        shear_modulus_Pa: 76.923e9,
        thermal_expansion_per_K: STEEL_EXPANSION_PER_K,
    };

    /// Poisson's ratio that goes with the two moduli of an isotropic metal, `ν = E/(2G) - 1`, at
    /// most the 0.5 of an incompressible one: beyond, contact stiffness would turn negative.
    pub fn poisson_ratio(&self) -> f64 {
        (self.youngs_modulus_Pa / (2.0 * self.shear_modulus_Pa) - 1.0).min(0.5)
    }

    /// Shortening of a pipe by the same pressure on all its surfaces, `(1 − 2ν)/E`, 1/Pa, times the
    /// part of a length that is of this metal.
    pub fn pressure_strain_per_Pa(&self, part: f64) -> f64 {
        part * (1.0 - 2.0 * self.poisson_ratio()) / self.youngs_modulus_Pa
    }
}
