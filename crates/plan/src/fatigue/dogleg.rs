//! Permissible dogleg severity by Lubinski.

use wholestring::string::Component;

use wholestring_judge::strength::PSI_PA;

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
