//! Constants of all elements of a block.

use serde::{Deserialize, Serialize};

use super::{
    material::{Rock, RockError},
    plasticity::Law,
};

/// An element whose shortest stretch falls below this is removed: `|F⁻¹|²` of one that is squeezed
/// to a half.
pub const MAX_SQUEEZED: f64 = 6.0;

/// Settings of the elements' integration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    /// Step as a fraction of the stable step of the stiffest element at rest. The margin is for
    /// elements that are compressed.
    pub step_fraction: f64,
    /// Linear bulk viscosity: pressure per `ρ c_p h` and rate of swelling. Raising it damps the
    /// waves of one element's length, and shortens the step.
    pub bulk_viscosity: f64,
    /// Stiffness against hourglassing, as a part of the element's own. Too little lets it
    /// hourglass, too much stiffens it in bending.
    pub hourglass_stiffness: f64,
    /// Damping of hourglassing, as a part of the critical.
    pub hourglass_damping: f64,
    /// Factor on the density, for longer steps where inertia does not matter.
    pub density_factor: f64,
}

impl Default for Numerics {
    fn default() -> Self {
        Self {
            step_fraction: 0.6,
            bulk_viscosity: 0.06,
            hourglass_stiffness: 0.05,
            hourglass_damping: 0.05,
            density_factor: 1.0,
        }
    }
}

/// Constants of all elements of a block.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Constants {
    /// Strength and stiffness.
    pub law: Law,
    /// Step, and the longest that it may be, s.
    pub dt_s: f64,
    pub longest_dt_s: f64,
    /// Volume, m³, and mass, kg, of an element.
    pub volume_m3: f64,
    pub mass_kg: f64,
    /// From sums over the corners to gradients, 1/m.
    pub gradient: [f64; 3],
    /// From a stress to the coefficients of the corners' forces, m².
    pub pull: [f64; 3],
    /// Bulk viscosity over the step, Pa.
    pub viscosity: f64,
    /// Hourglass stiffness, N/m, and damping, N·s/m, per unit of an hourglass sum.
    pub hourglass: f64,
    pub hourglass_damping: f64,
    /// Pressure of the fluid in the hole, Pa.
    pub pressure_Pa: f64,
    /// Impedances of outer faces per area, Pa·s/m, to pressure and shear waves.
    pub impedance: [f64; 2],
}

impl Constants {
    /// For elements of given edges.
    pub fn new(
        rock: &Rock,
        size_m: [f64; 3],
        pressure_Pa: f64,
        numerics: &Numerics,
    ) -> Result<Self, RockError> {
        let volume_m3 = size_m.iter().product::<f64>();
        let size = libm::cbrt(volume_m3);
        let law = Law::new(rock, size)?;
        let rock =
            Rock { density_kg_per_m3: rock.density_kg_per_m3 * numerics.density_factor, ..*rock };
        let density = rock.density_kg_per_m3;
        let (lame, shear) = (rock.lame_Pa(), rock.shear_modulus_Pa());
        let squares = size_m.map(|h| 1.0 / (h * h));
        let hourglass = numerics.hourglass_stiffness * (lame + 2.0 * shear) * volume_m3 / 16.0
            * squares.iter().sum::<f64>();
        // An element's highest frequencies: it swells, it shears, it hourglasses. No mesh of it has
        // a higher one.
        let swelling =
            squares.iter().map(|square| square * (lame * 3.0 + 2.0 * shear)).fold(0.0, f64::max);
        let shearing = shear
            * (squares.iter().sum::<f64>() - squares.iter().copied().fold(f64::MAX, f64::min));
        let hourglassing = 16.0 * hourglass / volume_m3;
        let highest = 2.0 * (swelling.max(shearing).max(hourglassing) / density).sqrt();
        let wave = rock.pressure_wave_m_per_s();
        let shortest = size_m.into_iter().fold(f64::INFINITY, f64::min);
        // The damping ratio of an element that swells and shrinks.
        let ratio =
            numerics.bulk_viscosity * (3.0 * (lame + 2.0 * shear) / rock.bulk_modulus_Pa()).sqrt();
        let bearable_s = 2.0 / highest * ((1.0 + ratio * ratio).sqrt() - ratio);
        let dt_s = numerics.step_fraction * bearable_s;
        let hourglass_frequency = 8.0 * (hourglass / (density * volume_m3)).sqrt();
        Ok(Self {
            law,
            dt_s,
            longest_dt_s: dt_s,
            volume_m3,
            mass_kg: density * volume_m3,
            gradient: size_m.map(|h| 0.25 / h),
            pull: size_m.map(|h| 0.25 * volume_m3 / h),
            viscosity: numerics.bulk_viscosity * density * wave * shortest / dt_s,
            hourglass,
            hourglass_damping: 2.0 * numerics.hourglass_damping * hourglass / hourglass_frequency,
            pressure_Pa,
            impedance: [density * wave, density * rock.shear_wave_m_per_s()],
        })
    }

    /// Takes the longest steps that share a time equally. How many.
    pub fn share(&mut self, time_s: f64) -> usize {
        let steps = (time_s / self.longest_dt_s).ceil().max(1.0);
        let dt_s = time_s / steps;
        self.viscosity *= self.dt_s / dt_s;
        self.dt_s = dt_s;
        steps as usize
    }
}
