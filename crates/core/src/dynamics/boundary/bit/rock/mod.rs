//! Solid rock under the bit: elements that the face of the bit breaks.

mod cut;
mod run_in;

pub(super) use self::cut::RockCut;
pub use self::{cut::RunIn, run_in::Standing};

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::{
    damage::Damaged,
    dynamics::{
        assemble::SetupError,
        boundary::bit::{
            cutters::{Cutters, SteadyCut},
            law::rules::{CutStart, CutState, LawRules},
            motor::Drive,
            step::{Approach, RockReaction},
        },
    },
    rock::{BitShape, DrillingSpec},
};

// Solid rock as a law of the bit.

/// Maximum fraction of the bottom's nodes that a bit touches: twice the fraction of bits of 60 and
/// 216 mm on elements of 3 to 12 mm.
const TOUCHED: f64 = 0.125;

/// Inclination of the force on an insert that scrapes, over that around: a face raked back by 45°.
const INSERT_RAKE_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// Solid rock: the face of the bit breaks elements, and receives their reaction in all six
/// components.
///
/// Sideways the bit's own spring holds it besides: a wall of elements leaves its gauge room to bang
/// about.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RockLaw {
    /// The bit and its rock.
    pub drilling: DrillingSpec,
}

impl RockLaw {
    /// Equivalent cutters of Detournay and Defourny's law: an **estimate**, which only sets the
    /// hoist's start and the twist of the soft string.
    ///
    /// Sharp cutters whose intrinsic specific energy is the rock's unconfined strength, as it is
    /// about (Richard, Dagrain, Poyol and Detournay, *Engineering Geology* 147, 2012);
    /// `ζ = tan(θ + ψ)` of the back rake `θ` and the friction angle `ψ` between rock and cutter.
    pub fn estimate(&self) -> Cutters {
        let (diameter_m, core_m, rake_rad) = match &self.drilling.bit {
            BitShape::Pdc(bit) => (bit.diameter_m, bit.core_diameter_m, bit.back_rake_rad),
            BitShape::Insert(bit) => (bit.diameter_m, 0.0, INSERT_RAKE_RAD),
        };
        let friction = self.drilling.contact.friction;
        Cutters {
            radius_m: 0.5 * diameter_m,
            core_radius_m: 0.5 * core_m,
            intrinsic_specific_energy_Pa: self.drilling.block.rock.ucs_Pa(),
            cutter_inclination: libm::tan(rake_rad + libm::atan(friction)),
            wear_flat_m: 0.0,
            contact_strength_Pa: 0.0,
            bit_geometry: 1.0,
            friction,
        }
    }

    /// Expected steady drilling under a weight on bit, at a speed: [`Self::estimate`].
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let cutters = self.estimate();
        let depth_of_cut_m = weight_on_bit_N / cutters.cutting_N_per_m();
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: cutters.torque_N_m(weight_on_bit_N, 0.0),
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }

    /// Mass (kg) and moment of inertia about the hole (kg·m²) of the nodes of rock that the bit
    /// touches at the most, scaled as the density is. The contact is stable under a bit that has
    /// more.
    pub fn touched(&self) -> [f64; 2] {
        let block = &self.drilling.block;
        let cutters = self.estimate();
        let [outer, inner] = [cutters.radius_m, cutters.core_radius_m].map(|r| r * r);
        // A node of the bottom has half an element below it.
        let thick_m = 0.5 * block.size_m[2];
        let density = block.rock.density_kg_per_m3 * block.numerics.density_factor;
        let mass_kg = TOUCHED * density * thick_m * std::f64::consts::PI * (outer - inner);
        [mass_kg, 0.5 * mass_kg * (outer + inner)]
    }

    /// Stiffness of the intact rock under a stamp as wide as the bit, `2 E a/(1 − ν²)`, N/m.
    pub fn stiffness_N_per_m(&self) -> f64 {
        let rock = &self.drilling.block.rock;
        let radius_m = self.estimate().radius_m;
        2.0 * rock.youngs_modulus_Pa * radius_m / (1.0 - rock.poisson_ratio.powi(2))
    }
}

impl LawRules for RockLaw {
    type Cut = RockCut;

    fn check(&self) -> Result<(), SetupError> {
        Ok(self.drilling.check()?)
    }

    fn stiffness_N_per_m(&self) -> f64 {
        Self::stiffness_N_per_m(self)
    }

    fn steady_cut(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        Some(self.steady(weight_on_bit_N, rotary_speed_rad_per_s))
    }

    /// The bit is run in first, see [`Bit::stand`](crate::dynamics::boundary::bit::Bit::stand).
    fn begin(&self, _start: &CutStart<'_>) -> Option<RockCut> {
        None
    }
}

impl CutState for RockCut {
    type Law = RockLaw;

    fn check(&self, law: &RockLaw) -> Result<(), Damaged> {
        self.check_drilling(&law.drilling)
    }

    /// It takes the bit's node through the step by itself: [`RockCut::drill`].
    fn meet(&mut self, _at: &Approach, _drive: &mut Drive) -> Option<RockReaction> {
        None
    }
}
