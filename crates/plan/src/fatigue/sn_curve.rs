//! Endurance of pipe: cycles to failure under an alternating stress, the effect of a steady
//! tension, and the permissible dogleg severity.

use wholestring::string::Component;
use wholestring_judge::strength::PSI_PA;

/// An S-N curve of two slopes that meet at a knee, with an optional endurance limit: cycles `N` to
/// failure at an amplitude `S`,
///
#[doc = include_str!("../../equations/sn-curve.html")]
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SnCurve {
    /// Cycles at the knee `N_k`.
    pub knee_cycles: f64,
    /// Amplitude of the stress at the knee `S_k`, Pa: half of its range.
    pub knee_amplitude_Pa: f64,
    /// Exponent above the knee `m₁`.
    pub exponent: f64,
    /// Exponent below the knee `m₂`.
    pub exponent_below: f64,
    /// Amplitude, Pa, below which there is no damage.
    pub endurance_limit_Pa: Option<f64>,
}

impl SnCurve {
    /// DNV-RP-C203, curve B1 in air (as commonly printed): `log N = 15.117 − 4 log Δσ` up to 10⁷
    /// cycles, `17.146 − 5 log Δσ` beyond, `Δσ` the range in MPa. A design curve, two standard
    /// deviations below the mean, of smooth rolled metal: neither of threads, nor of slip cuts, nor
    /// of corroded pipe.
    pub const B1_IN_AIR: Self = Self {
        knee_cycles: 1e7,
        knee_amplitude_Pa: 53.483_45e6,
        exponent: 4.0,
        exponent_below: 5.0,
        endurance_limit_Pa: None,
    };

    /// Returns a curve of one slope through this number of cycles at an amplitude, Pa.
    pub const fn of_one_slope(cycles: f64, amplitude_Pa: f64, exponent: f64) -> Self {
        Self {
            knee_cycles: cycles,
            knee_amplitude_Pa: amplitude_Pa,
            exponent,
            exponent_below: exponent,
            endurance_limit_Pa: None,
        }
    }

    /// Returns the cycles to failure at an amplitude, Pa; infinite without damage.
    pub fn cycles(&self, amplitude_Pa: f64) -> f64 {
        let endured = self.endurance_limit_Pa.is_some_and(|limit_Pa| amplitude_Pa < limit_Pa);
        if amplitude_Pa <= 0.0 || endured {
            return f64::INFINITY;
        }
        let over = self.knee_amplitude_Pa / amplitude_Pa;
        let exponent = if over <= 1.0 { self.exponent } else { self.exponent_below };
        self.knee_cycles * libm::pow(over, exponent)
    }
}

impl Default for SnCurve {
    fn default() -> Self {
        Self::B1_IN_AIR
    }
}

// Effect of a steady tension on an alternating stress.

/// Minimum yield and tensile strength of the grades of drill pipe, psi (API Spec 5DP, as commonly
/// printed).
const GRADES_PSI: [[f64; 2]; 4] = [[75e3, 100e3], [95e3, 105e3], [105e3, 115e3], [135e3, 145e3]];

/// Relative difference below which two yield strengths are those of one grade.
const SAME: f64 = 5e-3;

/// Returns the minimum tensile strength of a grade of drill pipe, Pa, by its minimum yield
/// strength, Pa. For other metal it is the yield strength itself: Goodman's line becomes
/// Soderberg's, which is conservative.
pub fn minimum_tensile_strength_Pa(yield_strength_Pa: f64) -> f64 {
    let of_grade =
        |[yield_psi, _]: &&[f64; 2]| (yield_strength_Pa / (yield_psi * PSI_PA) - 1.0).abs() < SAME;
    let grade = GRADES_PSI.iter().find(of_grade);
    grade.map_or(yield_strength_Pa, |[_, tensile_psi]| tensile_psi * PSI_PA)
}

/// Returns the amplitude that damages without a mean stress as this one does with it, Pa (Goodman):
/// `S = σ_a/(1 − σ_m/σ_u)`. A mean compression counts as none; beyond the tensile strength it is
/// infinite.
pub fn equivalent_amplitude_Pa(amplitude_Pa: f64, mean_Pa: f64, tensile_strength_Pa: f64) -> f64 {
    let left = 1.0 - mean_Pa.max(0.0) / tensile_strength_Pa;
    if left > 0.0 { amplitude_Pa / left } else { f64::INFINITY }
}

// Permissible dogleg severity by Lubinski.

/// Endurance limit of the bending stress of a pipe under tension, of API RP 7G (as commonly
/// printed).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnduranceCurve {
    /// `σ_b = 19500 − 10/67 σ_t − 0.6/670² (σ_t − 33500)²` psi, up to 67,000 psi: of grade E-75.
    E75,
    /// `σ_b = 20000 (1 − σ_t/145000)` psi, up to 133,400 psi: of grade S-135.
    S135,
}

impl EnduranceCurve {
    /// Returns the curve for a minimum yield strength, Pa: that of S-135 from 105,000 psi on. The
    /// standard prints no others.
    pub fn of(yield_strength_Pa: f64) -> Self {
        if yield_strength_Pa > 100e3 * PSI_PA { Self::S135 } else { Self::E75 }
    }

    /// Returns the endurance limit of the bending stress, Pa, under a tensile stress, Pa; a
    /// compression counts as none.
    pub fn bending_Pa(self, tensile_Pa: f64) -> f64 {
        let tensile = tensile_Pa.max(0.0) / PSI_PA;
        let (bending, most) = match self {
            Self::E75 => {
                let apart = tensile - 33_500.0;
                let bow = 0.6 / (670.0 * 670.0) * apart * apart;
                (19_500.0 - 10.0 / 67.0 * tensile - bow, 67_000.0)
            }
            Self::S135 => (20_000.0 * (1.0 - tensile / 145_000.0), 133_400.0),
        };
        if tensile > most { 0.0 } else { bending.max(0.0) * PSI_PA }
    }
}

/// Returns the dogleg severity, rad/m, in which a pipe may turn indefinitely under an effective
/// tension, N (Lubinski 1961, API RP 7G), with `σ_b` the bending stress that `curve` allows at that
/// tension, `D` the diameter and `L` half of the distance between tool joints:
///
#[doc = include_str!("../../equations/permissible-dogleg.html")]
///
/// Without tool joints, and in compression, the pipe has the curvature of the hole.
pub fn permissible_dogleg_rad_per_m(
    component: &Component,
    tension_N: f64,
    curve: EnduranceCurve,
) -> f64 {
    let bending_Pa = curve.bending_Pa(tension_N / component.area_m2());
    let smooth = bending_Pa / (component.material.youngs_modulus_Pa * 0.5 * component.od_m);
    let half_spacing_m = component.joints.map_or(0.0, |joints| 0.5 * joints.spacing_m);
    let root = half_spacing_m * (tension_N.max(0.0) / component.bending_stiffness_N_m2()).sqrt();
    if root > 0.0 { smooth * libm::tanh(root) / root } else { smooth }
}
