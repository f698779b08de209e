//! Burst and collapse of a tube.

use super::PSI_PA;

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

// Collapse by API TR 5C3 (API RP 7G for drill pipe): four regimes by `D/t`.

/// Regime of a tube's collapse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CollapseRegime {
    /// The inner surface yields.
    Yield,
    /// Plastic: a fit of tests.
    Plastic,
    /// Between plastic and elastic.
    Transition,
    /// Elastic instability.
    Elastic,
    /// Not computed: the tension leaves less yield strength than the formulas allow.
    BeyondFormulas,
}

impl CollapseRegime {
    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Yield => "yield",
            Self::Plastic => "plastic",
            Self::Transition => "transition",
            Self::Elastic => "elastic",
            Self::BeyondFormulas => "beyond the formulas",
        }
    }
}

/// The pressure at which a tube collapses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collapse {
    /// Pressure outside over that inside, Pa.
    pub pressure_Pa: f64,
    /// Regime of the collapse; for [`CollapseRegime::BeyondFormulas`] the pressure is not a number.
    pub regime: CollapseRegime,
}

/// `46.95e6 psi`, the constant of elastic collapse.
const ELASTIC_PSI: f64 = 46.95e6;

impl Collapse {
    /// Computes the collapse of a tube with this outside diameter over wall and minimum yield
    /// strength, Pa, under an axial stress, Pa: that of the real force in the metal and the
    /// pressure inside together, `σ_a + p_i`. A tension reduces the yield strength by API TR 5C3,
    /// `Y_a = Y (√(1 − ¾ (σ/Y)²) − ½ σ/Y)`; a compression adds nothing. A tube that yields by its
    /// tension, or keeps so little strength that the fits give no positive pressure, has
    /// [none](CollapseRegime::BeyondFormulas).
    pub fn of(slenderness: f64, yield_strength_Pa: f64, axial_stress_Pa: f64) -> Self {
        let pulled = (axial_stress_Pa / yield_strength_Pa).max(0.0);
        let beyond = Self { pressure_Pa: f64::NAN, regime: CollapseRegime::BeyondFormulas };
        if pulled.is_nan() || pulled >= 1.0 {
            return beyond;
        }
        let left = (1.0 - 0.75 * pulled * pulled).sqrt() - 0.5 * pulled;
        let (pressure_psi, regime) = collapse_psi(slenderness, left * yield_strength_Pa / PSI_PA);
        if pressure_psi.is_nan() || pressure_psi <= 0.0 {
            return beyond;
        }
        Self { pressure_Pa: pressure_psi * PSI_PA, regime }
    }
}

/// The formulas of API TR 5C3 in psi, with its fits of the constants A, B, C, F and G to the yield
/// strength.
fn collapse_psi(slenderness: f64, y: f64) -> (f64, CollapseRegime) {
    let a = 2.8762 + y * (0.10679e-5 + y * (0.21301e-10 - y * 0.53132e-16));
    let b = 0.026233 + y * 0.50609e-6;
    let c = -465.93 + y * (0.030867 - y * (0.10483e-7 - y * 0.36989e-13));
    let ratio = b / a;
    let elastic_from = (2.0 + ratio) / (3.0 * ratio);
    let peak = 1.0 / elastic_from;
    let f = ELASTIC_PSI * peak.powi(3) / (y * (peak - ratio) * (1.0 - peak).powi(2));
    let g = f * ratio;
    let per_yield = b + c / y;
    let plastic_from =
        (((a - 2.0).powi(2) + 8.0 * per_yield).sqrt() + (a - 2.0)) / (2.0 * per_yield);
    let transition_from = y * (a - f) / (c + y * (b - g));
    if slenderness <= plastic_from {
        (2.0 * y * (slenderness - 1.0) / slenderness.powi(2), CollapseRegime::Yield)
    } else if slenderness <= transition_from {
        (y * (a / slenderness - b) - c, CollapseRegime::Plastic)
    } else if slenderness <= elastic_from {
        (y * (f / slenderness - g), CollapseRegime::Transition)
    } else {
        (ELASTIC_PSI / (slenderness * (slenderness - 1.0).powi(2)), CollapseRegime::Elastic)
    }
}
