//! Cross-section of a stretch of the string.

use std::f64::consts::FRAC_PI_4;

use crate::string::{DrillString, FreeStrain};

/// Stiffness and inertia per length of a stretch of the string.
///
/// A stretch that spans several components has their series stiffness (the mean of the compliances)
/// and their mean inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// `EA`, N.
    pub axial_stiffness_N: f64,
    /// `κGA`, N.
    pub shear_stiffness_N: f64,
    /// `EI`, N·m².
    pub bending_stiffness_N_m2: f64,
    /// `GJ`, N·m².
    pub torsional_stiffness_N_m2: f64,
    /// Mass of the steel, tool joints included, kg/m.
    pub steel_kg_per_m: f64,
    /// Volume of the steel, m³/m: the part that displaces mud.
    pub steel_m2: f64,
    /// Area of the bore, m².
    pub bore_m2: f64,
    /// Moment of inertia about the axis, kg·m²/m.
    pub polar_inertia_kg_m: f64,
    /// Outside diameter, m.
    pub od_m: f64,
    /// Shortening of a closed string by mud pressure inside and outside, `(1 − 2ν)/E`, 1/Pa.
    pub pressure_strain_per_Pa: f64,
    /// Coefficient of thermal expansion, 1/K.
    pub thermal_strain_per_K: f64,
}

impl Section {
    /// The mean section of `string` between two distances from the bit, m.
    pub fn between(string: &DrillString, from_bit_m: f64, to_bit_m: f64) -> Self {
        let mut mean = Self {
            axial_stiffness_N: 0.0,
            shear_stiffness_N: 0.0,
            bending_stiffness_N_m2: 0.0,
            torsional_stiffness_N_m2: 0.0,
            steel_kg_per_m: 0.0,
            steel_m2: 0.0,
            bore_m2: 0.0,
            polar_inertia_kg_m: 0.0,
            od_m: 0.0,
            pressure_strain_per_Pa: 0.0,
            thermal_strain_per_K: 0.0,
        };
        for (component, part) in string.parts_between(from_bit_m, to_bit_m) {
            let g = component.material.shear_modulus_Pa;
            let area = component.area_m2();
            let nu = component.material.poisson_ratio();
            let kappa = shear_factor(nu, component.id_m / component.od_m);
            mean.axial_stiffness_N += part / component.axial_stiffness_N();
            mean.shear_stiffness_N += part / (kappa * g * area);
            mean.bending_stiffness_N_m2 += part / component.bending_stiffness_N_m2();
            mean.torsional_stiffness_N_m2 += part / component.torsional_stiffness_N_m2();
            let steel = component.mass_per_length_kg_per_m;
            mean.steel_kg_per_m += part * steel;
            mean.steel_m2 += part * steel / component.material.density_kg_per_m3;
            mean.bore_m2 += part * component.inner_area_m2();
            mean.polar_inertia_kg_m +=
                part * steel * component.polar_moment_m4() / component.area_m2();
            mean.od_m += part * component.od_m;
            mean.pressure_strain_per_Pa += component.material.pressure_strain_per_Pa(part);
            mean.thermal_strain_per_K += part * component.material.thermal_expansion_per_K;
        }
        mean.axial_stiffness_N = 1.0 / mean.axial_stiffness_N;
        mean.shear_stiffness_N = 1.0 / mean.shear_stiffness_N;
        mean.bending_stiffness_N_m2 = 1.0 / mean.bending_stiffness_N_m2;
        mean.torsional_stiffness_N_m2 = 1.0 / mean.torsional_stiffness_N_m2;
        mean
    }

    /// Buoyed weight, N/m.
    pub fn buoyed_weight_N_per_m(&self, mud_kg_per_m3: f64) -> f64 {
        crate::GRAVITY_M_PER_S2 * (self.steel_kg_per_m - mud_kg_per_m3 * self.steel_m2)
    }

    /// Strain of the stretch without effective tension, on its mean areas.
    pub fn free_strain(&self) -> FreeStrain {
        FreeStrain {
            pressure_per_Pa: self.pressure_strain_per_Pa,
            outer_m2: FRAC_PI_4 * self.od_m * self.od_m,
            bore_m2: self.bore_m2,
            thermal_per_K: self.thermal_strain_per_K,
        }
    }
}

/// Shear correction factor of a thick ring: between 0.53 (thin) and 0.89 (solid); Cowper's formula
/// for Poisson's ratio `nu` and bore ratio `m` = inner over outer radius.
///
/// Source: G. R. Cowper, *The Shear Coefficient in Timoshenko's Beam Theory* (1966), hollow circle.
pub fn shear_factor(nu: f64, m: f64) -> f64 {
    let q = (1.0 + m * m).powi(2);
    6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m * m)
}
