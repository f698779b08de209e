//! Margin of overpull.

/// Part of the tensile yield that is allowed by default (API RP 7G: customary).
pub const ALLOWED_PART_OF_YIELD: f64 = 0.9;

/// Margin of overpull, N, `α P₀ − T` (API RP 7G): the capacity of a section of the string, a part
/// `α` of its tensile yield, beyond its present tension.
pub fn margin_of_overpull_N(tensile_yield_N: f64, allowed_part: f64, tension_N: f64) -> f64 {
    allowed_part * tensile_yield_N - tension_N
}
