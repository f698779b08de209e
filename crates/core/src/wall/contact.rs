//! Normal contact between string and wall, solved implicitly within a step.
//!
//! Penetration is geometry: `α = u + r − R`. Both laws take it at the end of the step, which makes any
//! stiffness stable and the mean forces independent of it. The price is restitution: a blow shorter than
//! a few steps loses most of its energy. At 0.55 ms, about the step of 3.2 m elements, a node of 120 kg on rock
//! with the default dissipation rebounds with 0.47 of 0.01 m/s, 0.33 of 0.1, 0.22 of 0.5 and 0.13 of 2 m/s;
//! the law itself gives 0.997, 0.97, 0.86 and 0.59.

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
/// `alpha`, approaching at `v_n`. One newton takes `dt²/m` of `alpha` away; `inertia` is `m/dt²`. The
/// approach is the one without contact, not that of the step's end.
///
/// With `y = √α` the law is the cubic `y² + G y³ = α_free`, `G = K (1 + d v_n) dt²/m`; in `z = G y` it is
/// `z²(1 + z) = G² α_free = r²`, one curve for every contact. A rational function within 2 % of it for
/// `r < 60` and two Newton steps solve it to 1e-6 there; beyond (walls stiffer than any) the
/// force stays between zero and the one that takes all penetration away. `d` is never allowed to pull.
#[inline(always)]
pub fn hertz<N: Number>(alpha: N, v_n: N, stiffness: N, dissipation: N, inertia: N) -> N {
    let one = N::splat(1.0);
    let (two, three) = (N::splat(2.0), N::splat(3.0));
    let tiny = N::splat(1e-300);
    let alpha = alpha.max(N::zero());
    let k = stiffness * dissipation.mul_add(v_n, one).max(N::zero());
    // r = s/I. Powers of I are multiplied through, which leaves two divisions of five.
    let (s, i) = (k * alpha.sqrt(), inertia);
    let (s2, i2) = (s * s, i * i);
    let p = s * N::splat(0.229).mul_add(s, i);
    let q = N::splat(0.006_43).mul_add(s2, N::splat(0.6016).mul_add(s * i, i2));
    // Newton for z²(1 + z) − r²: z → (z²(1 + 2z) + r²)/(z(2 + 3z)), first from z = p/q.
    let above = (i2 * p * p).mul_add(two.mul_add(p, q), s2 * (q * q * q));
    let below = (i2 * p * q).mul_add(three.mul_add(p, two * q), tiny);
    let z = above / below;
    let above = (i2 * z * z).mul_add(two.mul_add(z, one), s2);
    let below = (i2 * z).mul_add(three.mul_add(z, two), tiny);
    // N = (m/dt²) α z/(1 + z): what is left of the penetration carries the force.
    i * alpha * (above / (above + below))
}

/// `N = max(0, k α + c v_n)` while the surfaces overlap, at the end of the step `dt` of a node of
/// mass `mass`.
#[inline(always)]
pub fn linear<N: Number>(alpha: N, v_n: N, k: N, c: N, mass: N, dt: N) -> N {
    let free = k.mul_add(alpha, c * v_n);
    let force = free * mass / k.mul_add(dt * dt, c.mul_add(dt, mass));
    alpha.if_positive(force.max(N::zero()), N::zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The implicit law satisfies its own equation for every stiffness and depth of a contact. The
    /// tolerance is that of two Newton steps (see [`hertz`]).
    #[test]
    fn hertz_solves_its_cubic() {
        let inertia = 150.0 / 3e-7;
        let mut solved = 0;
        for exponent in -12..=0 {
            for k in [1e6, 1e9, 1e11, 2e12] {
                let alpha = 10f64.powi(exponent);
                let n = hertz(alpha, 0.0, k, 0.5, inertia);
                let end = alpha - n / inertia;
                assert!(n > 0.0 && end >= 0.0);
                // Where next to nothing is left of the penetration, its digits are lost.
                if k * alpha.sqrt() / inertia < 60.0 {
                    let law = k * end.powf(1.5);
                    assert!(
                        (law / n - 1.0).abs() < 1e-5,
                        "alpha {alpha} k {k}: {law} {n}"
                    );
                    solved += 1;
                }
            }
        }
        assert!(solved > 30);
    }

    #[test]
    fn nothing_pulls() {
        assert_eq!(hertz(-1e-3, 1.0, 1e11, 0.5, 1e9), 0.0);
        assert_eq!(hertz(1e-6, -10.0, 1e11, 0.5, 1e9), 0.0);
        assert_eq!(linear(-1e-6, 1.0, 1e7, 1e4, 200.0, 5e-4), 0.0);
        assert_eq!(linear(1e-6, -10.0, 1e7, 1e4, 200.0, 5e-4), 0.0);
    }
}
