//! Effect of a steady tension on an alternating stress.

use wholestring_judge::strength::PSI_PA;

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
