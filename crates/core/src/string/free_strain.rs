//! Strain of pipe without effective tension: by the pressures on it and by its temperature.
//!
//! Theory: `docs/src/theory/mud.md`.

use super::Component;

/// Temperature at which the length of pipe is measured, K: 20 °C, the standard reference temperature
/// of ISO 1:2022.
pub const REFERENCE_TEMPERATURE_K: f64 = 293.15;

/// Pressures and temperature of a place of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surroundings {
    /// Pressure in the annulus, Pa.
    pub outside_Pa: f64,
    /// Pressure inside the string, Pa.
    pub inside_Pa: f64,
    /// Temperature, K, where it is known; [`REFERENCE_TEMPERATURE_K`] elsewhere.
    pub temperature_K: Option<f64>,
}

/// Axial strain of a closed pipe without effective tension.
///
/// Pressures outside and inside, `p_o` on the area `A_o` and `p_i` on the bore `A_i`, strain it by
/// `−(1 − 2ν)/E · (p_o A_o − p_i A_i)/(A_o − A_i)` (A. Lubinski, W. S. Althouse and J. L. Logan,
/// *Helical Buckling of Tubing Sealed in Packers*, 1962), and a temperature `T` by `α (T − T_ref)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeStrain {
    /// `(1 − 2ν)/E`, 1/Pa.
    pub pressure_per_Pa: f64,
    /// Area within the outside diameter, m².
    pub outer_m2: f64,
    /// Area of the bore, m².
    pub bore_m2: f64,
    /// Coefficient of thermal expansion `α`, 1/K.
    pub thermal_per_K: f64,
}

impl FreeStrain {
    /// The strain of a component.
    pub fn of(component: &Component) -> Self {
        Self {
            pressure_per_Pa: component.material.pressure_strain_per_Pa(1.0),
            outer_m2: std::f64::consts::FRAC_PI_4 * component.od_m * component.od_m,
            bore_m2: component.inner_area_m2(),
            thermal_per_K: component.material.thermal_expansion_per_K,
        }
    }

    /// The elongation of a length, m: all results are then in metres.
    pub fn over(self, length_m: f64) -> Self {
        Self {
            pressure_per_Pa: length_m * self.pressure_per_Pa,
            thermal_per_K: length_m * self.thermal_per_K,
            ..self
        }
    }

    /// Strain by pressures alone, which the caller may give without those of the fluid at rest: it
    /// is linear in them.
    pub fn by_pressures(&self, outside_Pa: f64, inside_Pa: f64) -> f64 {
        // The same pressure on all sides acts as on a solid body, to the last digit.
        if outside_Pa == inside_Pa {
            return -self.pressure_per_Pa * outside_Pa;
        }
        let Self { pressure_per_Pa, outer_m2, bore_m2, .. } = *self;
        -pressure_per_Pa * (outside_Pa * outer_m2 - inside_Pa * bore_m2) / (outer_m2 - bore_m2)
    }

    /// Strain in these surroundings.
    pub fn strain(&self, around: &Surroundings) -> f64 {
        let pressed = self.by_pressures(around.outside_Pa, around.inside_Pa);
        match around.temperature_K {
            Some(kelvin) => pressed + self.thermal_per_K * (kelvin - REFERENCE_TEMPERATURE_K),
            None => pressed,
        }
    }
}
