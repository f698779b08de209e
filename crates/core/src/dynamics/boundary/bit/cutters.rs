//! Weight and torque of cutting and of wear flats: the law that drag bits have in common.

use serde::{Deserialize, Serialize};

use crate::dynamics::assemble::{SetupError, check_numbers};

/// The cutters of a bit in a rock, by Detournay and Defourny (*International Journal of Rock
/// Mechanics* 29, 1992).
///
/// A bit that takes the depth `d` per revolution cuts with `W_c = ζ (a − b) ε d` and `T_c = (a² −
/// b²) ε d/2`; wear flats under the weight `W_f` rub with `T_f = μ γ (a + b) W_f/2`, and carry no
/// more than `σ (a − b) l` by themselves. `b` is the radius of the core that a core bit leaves,
/// zero of others.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Cutters {
    /// Radius `a` of the bit, m.
    pub radius_m: f64,
    /// Radius `b` of the core that it leaves, m.
    pub core_radius_m: f64,
    /// Intrinsic specific energy `ε`, Pa: work that cutting takes per volume of rock.
    pub intrinsic_specific_energy_Pa: f64,
    /// Inclination `ζ` of the cutting force: its part along the hole over its part around.
    pub cutter_inclination: f64,
    /// Length `l` of the wear flats of all blades together, m.
    pub wear_flat_m: f64,
    /// Strength `σ` of the contact under the wear flats, Pa.
    pub contact_strength_Pa: f64,
    /// Geometry `γ` of the bit: 1 where the wear flats are spread evenly over its radius.
    pub bit_geometry: f64,
    /// Friction `μ` at the wear flats.
    pub friction: f64,
}

impl Cutters {
    /// Refuses numbers that no run can use.
    pub(super) fn check(&self) -> Result<(), SetupError> {
        check_numbers(
            &[
                ("bit.radius_m", self.radius_m),
                ("bit.radius_m less bit.core_radius_m", self.width_m()),
                ("bit.intrinsic_specific_energy_Pa", self.intrinsic_specific_energy_Pa),
                ("bit.cutter_inclination", self.cutter_inclination),
            ],
            &[
                ("bit.core_radius_m", self.core_radius_m),
                ("bit.wear_flat_m", self.wear_flat_m),
                ("bit.contact_strength_Pa", self.contact_strength_Pa),
                ("bit.bit_geometry", self.bit_geometry),
                ("bit.friction", self.friction),
            ],
        )
    }

    /// Weight that cutting takes per depth of cut of a revolution, `ζ (a − b) ε`, N/m.
    pub fn cutting_N_per_m(&self) -> f64 {
        self.cutter_inclination * self.width_m() * self.intrinsic_specific_energy_Pa
    }

    /// Weight on the wear flats in full contact, `σ (a − b) l`, N.
    pub fn wear_flat_weight_N(&self) -> f64 {
        self.contact_strength_Pa * self.width_m() * self.wear_flat_m
    }

    /// Torque of cutting with `cutting_N` while the wear flats carry `bearing_N`, N·m: both act, on
    /// average, halfway between the core and the gauge.
    pub fn torque_N_m(&self, cutting_N: f64, bearing_N: f64) -> f64 {
        let rubbing_N = self.friction * self.bit_geometry * bearing_N;
        0.5 * (self.radius_m + self.core_radius_m)
            * (cutting_N / self.cutter_inclination + rubbing_N)
    }

    /// Width of the ring that is cut, m.
    fn width_m(&self) -> f64 {
        self.radius_m - self.core_radius_m
    }
}

/// Steady drilling of a bit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SteadyCut {
    /// Depth of cut per revolution `d`, m.
    pub depth_of_cut_m: f64,
    /// Torque, N·m.
    pub torque_N_m: f64,
    /// Rate of penetration, m/s.
    pub rate_of_penetration_m_per_s: f64,
}
