//! Burst and collapse of a tube.

use super::collapse::Collapse;

/// Least wall of a new pipe over its nominal wall: API Spec 5DP and 5CT allow 12.5 % less.
pub const MILL_TOLERANCE: f64 = 0.875;

/// Dimensions and strength that burst and collapse of a tube need.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    /// Nominal outside diameter, m.
    pub od_m: f64,
    /// Nominal inside diameter, m.
    pub id_m: f64,
    /// Minimum yield strength, Pa.
    pub yield_strength_Pa: f64,
}

impl Tube {
    /// Nominal wall, m.
    pub fn wall_m(&self) -> f64 {
        0.5 * (self.od_m - self.id_m)
    }

    /// Pressure inside over that outside at which a tube with this wall yields, Pa: Barlow's
    /// `2 Y t/D` with the nominal outside diameter (API RP 7G, API TR 5C3).
    pub fn barlow_Pa(&self, wall_m: f64) -> f64 {
        2.0 * self.yield_strength_Pa * wall_m.max(0.0) / self.od_m
    }

    /// The same for new pipe, `0.875 · 2 Y t/D`, because its wall may be thinner by that factor.
    pub fn burst_Pa(&self) -> f64 {
        self.barlow_Pa(MILL_TOLERANCE * self.wall_m())
    }

    /// Pressure outside over that inside at which the new tube collapses, and its regime.
    /// `axial_stress_Pa` is that of the real force in the metal and the pressure inside together,
    /// `σ_a + p_i`.
    pub fn collapse(&self, axial_stress_Pa: f64) -> Collapse {
        Collapse::of(self.od_m / self.wall_m(), self.yield_strength_Pa, axial_stress_Pa)
    }
}
