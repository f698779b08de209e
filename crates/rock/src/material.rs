//! Rock, and the parameters of its strength.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::named_numbers::named_numbers;

/// Isotropic, elastic up to Drucker and Prager's cone, brittle beyond it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rock {
    /// Density, kg/m³.
    pub density_kg_per_m3: f64,
    /// Young's modulus, Pa.
    pub youngs_modulus_Pa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Cohesion of Mohr and Coulomb, Pa.
    pub cohesion_Pa: f64,
    /// Friction angle of Mohr and Coulomb, rad.
    pub friction_angle_rad: f64,
    /// Dilation angle, rad; the friction angle at most. Zero: the rock shears without swelling.
    pub dilation_angle_rad: f64,
    /// Strength in uniaxial tension, Pa. Above the limit of the cone it has no effect.
    pub tensile_strength_Pa: f64,
    /// Energy that a tensile crack takes per area, J/m².
    pub tensile_fracture_energy_J_per_m2: f64,
    /// Energy that a crushed band takes per area in uniaxial compression, J/m².
    pub compressive_fracture_energy_J_per_m2: f64,
    /// Minimum energy of failure per volume, in tension and in compression, J/m³: where cracks are
    /// closer than an element is wide it is crushed as a whole. Zero: there are single cracks
    /// alone, which take the energies per area.
    pub crushing_energy_J_per_m3: f64,
}

/// Energy that crushing takes per volume, over the unconfined strength. Calibrated: a bit's work
/// per drilled volume is then about the strength.
const CRUSHING: f64 = 0.085;

/// Width of a band that takes as much to crush per area as per volume, m: a few grains.
const CRUSHED_M: f64 = 2e-3;

named_numbers! {
    /// Numbers that describe a rock.
    RockNumber {
        Density "the density",
        YoungsModulus "Young's modulus",
        PoissonRatio "Poisson's ratio",
        Cohesion "the cohesion",
        FrictionAngle "the friction angle",
        DilationAngle "the dilation angle",
        TensileStrength "the tensile strength",
        TensileFractureEnergy "the fracture energy in tension",
        CompressiveFractureEnergy "the fracture energy in compression",
        CrushingEnergy "the crushing energy",
    }
}

/// Why a rock, or a block of it, cannot be.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RockError {
    /// A number that no rock has.
    #[error("{number} of the rock is {value}, expected {expected}")]
    OutOfRange {
        /// Which number.
        number: RockNumber,
        /// Its value, in SI units.
        value: f64,
        /// Expected range.
        expected: &'static str,
    },
    /// The elastic energy of an element is more than the energy of its failure: it would snap, not
    /// soften.
    #[error(
        "elements of {size_m:.2e} m are too large for the fracture energy of the rock: \
         they must be smaller than {largest_m:.2e} m"
    )]
    TooLarge {
        /// Size of an element, m.
        size_m: f64,
        /// The size to stay below, m.
        largest_m: f64,
    },
    /// A block without an element, or too large for its indices.
    #[error(
        "a block of {0} x {1} x {2} elements: expected at least one in each direction and 4e9 \
         nodes at most"
    )]
    Cells(usize, usize, usize),
}

/// Drucker and Prager's cone `√J₂ + α I₁ = k`, tension positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Slope.
    pub alpha: f64,
    /// Half of the strength in pure shear, in the sense of √J₂, Pa.
    pub k_Pa: f64,
}

/// Slope of the cone through the compressive corners of Mohr and Coulomb's pyramid of an angle.
fn slope(angle_rad: f64) -> f64 {
    let sin = libm::sin(angle_rad);
    2.0 * sin / (3.0_f64.sqrt() * (3.0 - sin))
}

impl Rock {
    /// A rock known by its unconfined compressive strength, Pa, alone.
    ///
    /// The rest is typical of sandstone and limestone: a modulus of 300 times the strength (the
    /// middle of Deere and Miller's class of average modulus ratio, 200 to 500), Poisson's ratio
    /// 0.25, 2500 kg/m³, friction angle 35° and dilation angle 10°, a tenth of the strength in
    /// tension, 80 J/m² for a tensile crack and a hundred times that, the square of the ratio of
    /// the strengths, for a crushed band. Nothing is crushed as a whole.
    pub fn of_strength(ucs_Pa: f64) -> Self {
        let friction_angle_rad = 35.0_f64.to_radians();
        let (sin, cos) = libm::sincos(friction_angle_rad);
        Self {
            density_kg_per_m3: 2500.0,
            youngs_modulus_Pa: 300.0 * ucs_Pa,
            poisson_ratio: 0.25,
            cohesion_Pa: ucs_Pa * (1.0 - sin) / (2.0 * cos),
            friction_angle_rad,
            dilation_angle_rad: 10.0_f64.to_radians(),
            tensile_strength_Pa: 0.1 * ucs_Pa,
            tensile_fracture_energy_J_per_m2: 80.0,
            compressive_fracture_energy_J_per_m2: 8000.0,
            crushing_energy_J_per_m3: 0.0,
        }
    }

    /// A rock to be drilled, known by its unconfined compressive strength, Pa, alone.
    ///
    /// Failure takes 0.085 of the strength per volume in elements above 2 mm, an energy per area
    /// below. The number is calibrated: with it a bit's work per drilled volume is about the
    /// strength, as for sharp cutters (Richard, Dagrain, Poyol and Detournay 2012). The rest is
    /// that of [`of_strength`](Self::of_strength). Theory: `docs/src/theory/rock.md`.
    pub fn for_drilling(ucs_Pa: f64) -> Self {
        let crushing_energy_J_per_m3 = CRUSHING * ucs_Pa;
        Self {
            crushing_energy_J_per_m3,
            compressive_fracture_energy_J_per_m2: crushing_energy_J_per_m3 * CRUSHED_M,
            ..Self::of_strength(ucs_Pa)
        }
    }

    /// Energy of failure in tension and in compression in elements of a size, J/m².
    pub(super) fn failure_J_per_m2(&self, size_m: f64) -> [f64; 2] {
        [self.tensile_fracture_energy_J_per_m2, self.compressive_fracture_energy_J_per_m2]
            .map(|crack| crack.max(self.crushing_energy_J_per_m3 * size_m))
    }

    /// Unconfined compressive strength `2 c cos φ/(1 − sin φ)`, Pa.
    pub fn ucs_Pa(&self) -> f64 {
        let (sin, cos) = libm::sincos(self.friction_angle_rad);
        2.0 * self.cohesion_Pa * cos / (1.0 - sin)
    }

    /// The cone that agrees with Mohr and Coulomb in triaxial compression:
    /// `α = 2 sin φ/(√3 (3 − sin φ))`, `k = 6 c cos φ/(√3 (3 − sin φ))`.
    pub fn cone(&self) -> Cone {
        let (sin, cos) = libm::sincos(self.friction_angle_rad);
        Cone {
            alpha: slope(self.friction_angle_rad),
            k_Pa: 6.0 * self.cohesion_Pa * cos / (3.0_f64.sqrt() * (3.0 - sin)),
        }
    }

    /// Slope of the plastic potential.
    pub fn dilation_slope(&self) -> f64 {
        slope(self.dilation_angle_rad)
    }

    /// Maximum sum of the principal stresses in the rock, Pa: the tensile strength, or the cone's
    /// apex.
    pub fn largest_tension_Pa(&self) -> f64 {
        let Cone { alpha, k_Pa } = self.cone();
        if self.tensile_strength_Pa * alpha < k_Pa {
            self.tensile_strength_Pa
        } else {
            k_Pa / alpha
        }
    }

    /// Shear modulus, Pa.
    pub fn shear_modulus_Pa(&self) -> f64 {
        0.5 * self.youngs_modulus_Pa / (1.0 + self.poisson_ratio)
    }

    /// Bulk modulus, Pa.
    pub fn bulk_modulus_Pa(&self) -> f64 {
        self.youngs_modulus_Pa / (3.0 * (1.0 - 2.0 * self.poisson_ratio))
    }

    /// Lamé's first constant, Pa.
    pub fn lame_Pa(&self) -> f64 {
        self.bulk_modulus_Pa() - 2.0 / 3.0 * self.shear_modulus_Pa()
    }

    /// Speed of pressure waves, m/s.
    pub fn pressure_wave_m_per_s(&self) -> f64 {
        ((self.lame_Pa() + 2.0 * self.shear_modulus_Pa()) / self.density_kg_per_m3).sqrt()
    }

    /// Speed of shear waves, m/s.
    pub fn shear_wave_m_per_s(&self) -> f64 {
        (self.shear_modulus_Pa() / self.density_kg_per_m3).sqrt()
    }

    /// Refuses numbers that no rock has.
    ///
    /// # Errors
    /// The first of them.
    pub fn check(&self) -> Result<(), RockError> {
        let above_zero = |number, value: f64, expected| (number, value, value > 0.0, expected);
        let positive = |number, value: f64, expected| {
            (number, value, value > 0.0 && value.is_finite(), expected)
        };
        let [friction, dilation] = [self.friction_angle_rad, self.dilation_angle_rad];
        let acute = friction > 0.0 && friction < std::f64::consts::FRAC_PI_2;
        let dilates = (0.0..=friction).contains(&dilation);
        let poisson = (0.0..0.5).contains(&self.poisson_ratio);
        let crushing = self.crushing_energy_J_per_m3;
        let checks = [
            positive(RockNumber::Density, self.density_kg_per_m3, "more than 0 kg/m3"),
            positive(RockNumber::YoungsModulus, self.youngs_modulus_Pa, "more than 0 Pa"),
            (RockNumber::PoissonRatio, self.poisson_ratio, poisson, "from 0 to below 0.5"),
            positive(RockNumber::Cohesion, self.cohesion_Pa, "more than 0 Pa"),
            (RockNumber::FrictionAngle, friction, acute, "between 0 and 90 deg"),
            (RockNumber::DilationAngle, dilation, dilates, "from 0 to the friction angle"),
            above_zero(RockNumber::TensileStrength, self.tensile_strength_Pa, "more than 0 Pa"),
            above_zero(
                RockNumber::TensileFractureEnergy,
                self.tensile_fracture_energy_J_per_m2,
                "more than 0 J/m2",
            ),
            above_zero(
                RockNumber::CompressiveFractureEnergy,
                self.compressive_fracture_energy_J_per_m2,
                "more than 0 J/m2",
            ),
            (RockNumber::CrushingEnergy, crushing, crushing >= 0.0, "0 J/m3 or more"),
        ];
        match checks.into_iter().find(|(_, _, valid, _)| !valid) {
            None => Ok(()),
            Some((number, value, _, expected)) => {
                Err(RockError::OutOfRange { number, value, expected })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rock_of_a_strength_has_that_strength() {
        let rock = Rock::of_strength(80e6);
        assert!((rock.ucs_Pa() / 80e6 - 1.0).abs() < 1e-12);
        rock.check().expect("a intact rock");
    }

    #[test]
    fn what_no_rock_has_is_named() {
        let rock = Rock { poisson_ratio: 0.5, ..Rock::of_strength(50e6) };
        let error = rock.check().expect_err("a rock as incompressible as water");
        assert_eq!(
            error.to_string(),
            "Poisson's ratio of the rock is 0.5, expected from 0 to below 0.5"
        );
        let rock = Rock { dilation_angle_rad: 1.0, ..Rock::of_strength(50e6) };
        assert!(rock.check().is_err());
    }
}
