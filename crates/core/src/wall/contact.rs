//! Normal contact between string and wall, solved implicitly within a step.
//!
//! Penetration is geometry: `α = u + r − R`. Both laws are evaluated at the end of the step, which
//! makes any stiffness stable and the mean forces independent of it.

use crate::rod::number::Number;

/// Smallest clearance `R − r` that the Hertz stiffness is computed with, m. A tool as large as its
/// hole would have an infinite one.
pub const SMALLEST_CLEARANCE_M: f64 = 1e-3;

/// Contact modulus `E*` of two materials, Pa: `1/E* = (1 − ν1²)/E1 + (1 − ν2²)/E2`.
pub fn contact_modulus_Pa(e1: f64, nu1: f64, e2: f64, nu2: f64) -> f64 {
    1.0 / ((1.0 - nu1 * nu1) / e1 + (1.0 - nu2 * nu2) / e2)
}

/// Hertz stiffness `K_h` of a pipe of radius `r` on a hole of radius `R`, N/m^1.5:
/// `K_h = (4/3) E* √(R r/(R − r))`, so that `N = K_h α^1.5` is the article's (5).
pub fn hertz_stiffness(modulus_Pa: f64, hole_radius_m: f64, pipe_radius_m: f64) -> f64 {
    let clearance = (hole_radius_m - pipe_radius_m).max(SMALLEST_CLEARANCE_M);
    4.0 / 3.0 * modulus_Pa * (hole_radius_m * pipe_radius_m / clearance).sqrt()
}

/// `N = K α^1.5 (1 + d v_n)` at the end of a step that, without contact, would end at penetration
/// `alpha`; `compliance` is the penetration that one newton takes away, `dt²/m`.
///
/// With `y = √α` the law is the cubic `y² + G K' y³ = α_free`, `K' = K (1 + d v_n)`; in `z = G K' y`
/// it is `z²(1 + z) = (G K')² α_free`, one curve for every contact, solved by two Newton steps from
/// `r/√(1 + r/2)`: within 1e-5 of the root for any contact of pipe on wall. `d` is never allowed to
/// pull.
#[inline(always)]
pub fn hertz<N: Number>(alpha: N, v_n: N, stiffness: N, dissipation: N, compliance: N) -> N {
    let one = N::splat(1.0);
    let two = N::splat(2.0);
    let alpha = alpha.max(N::zero());
    let k = stiffness * dissipation.mul_add(v_n, one).max(N::zero());
    let gk = compliance * k;
    let root = alpha.sqrt();
    let r = gk * root;
    let mut z = r / N::splat(0.5).mul_add(r, one).sqrt();
    for _ in 0..2 {
        let s = one + z;
        let excess = two * (z * s - r * s.sqrt());
        z = z - excess / N::splat(3.0).mul_add(z, two);
    }
    let y2 = alpha / (one + z.max(N::zero()));
    k * (y2 * y2.sqrt())
}

/// `N = max(0, k α + c v_n)` while the surfaces overlap, at the end of the step; `compliance` is
/// `dt²/m` and `mobility` `dt/m`.
#[inline(always)]
pub fn linear<N: Number>(alpha: N, v_n: N, k: N, c: N, compliance: N, mobility: N) -> N {
    let one = N::splat(1.0);
    let free = k.mul_add(alpha, c * v_n);
    let force = free / k.mul_add(compliance, c.mul_add(mobility, one));
    alpha.if_positive(force.max(N::zero()), N::zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The implicit law satisfies its own equation over every stiffness and depth a contact can
    /// have. The tolerance is that of two Newton steps (see [`hertz`]): `r` stays below 100.
    #[test]
    fn hertz_solves_its_cubic() {
        for exponent in -12..=0 {
            for k in [1e6, 1e9, 1e11, 2e12] {
                let (alpha, compliance) = (10f64.powi(exponent), 3e-7 / 150.0);
                let n = hertz(alpha, 0.0, k, 0.5, compliance);
                let end = alpha - compliance * n;
                let law = k * end.max(0.0).powf(1.5);
                let r = compliance * k * alpha.sqrt();
                if r < 100.0 {
                    assert!((law / n - 1.0).abs() < 1e-3, "alpha {alpha} k {k}: {law} {n}");
                }
                assert!(n * compliance <= alpha * (1.0 + 1e-12));
            }
        }
    }

    #[test]
    fn nothing_pulls() {
        assert_eq!(hertz(-1e-3, 1.0, 1e11, 0.5, 1e-9), 0.0);
        assert_eq!(hertz(1e-6, -10.0, 1e11, 0.5, 1e-9), 0.0);
        assert_eq!(linear(-1e-6, 1.0, 1e7, 1e4, 1e-9, 1e-6), 0.0);
        assert_eq!(linear(1e-6, -10.0, 1e7, 1e4, 1e-9, 1e-6), 0.0);
    }
}
