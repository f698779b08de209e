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
}

impl Material {
    /// Steel of drill pipe by default: 7860 kg/m³, 210 GPa and 76.923 GPa.
    pub const STEEL: Self =
        Self { density_kg_per_m3: 7860.0, youngs_modulus_Pa: 210e9, shear_modulus_Pa: 76.923e9 };

    /// Poisson's ratio that goes with the two moduli of an isotropic metal, `ν = E/(2G) - 1`, at
    /// most the 0.5 of an incompressible one: beyond, contact stiffness would turn negative.
    pub fn poisson_ratio(&self) -> f64 {
        (self.youngs_modulus_Pa / (2.0 * self.shear_modulus_Pa) - 1.0).min(0.5)
    }
}
