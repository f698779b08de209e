//! Friction between string and wall, as an impulse capped at the value that stops the motion.
//!
//! A force that would reverse the sliding within the step is cut to the one that stops it: rest is
//! exact, and a resting string keeps its drag for ever. (A regularised law creeps and loses it.)

use crate::simd::number::Number;

/// Sliding speed at which the coefficient at rest has half decayed to the kinetic one by default,
/// m/s.
pub const STRIBECK_SPEED_M_PER_S: f64 = 0.1;

/// Coefficient of friction at the sliding speed whose square is `speed2`:
/// `μ = μ_k + (μ_s − μ_k)/(1 + (v/v_s)²)`, a rational form of Stribeck's decay; `decay` is
/// `1/v_s²`.
#[inline(always)]
pub fn coefficient<N: Number>(kinetic: N, rise: N, speed2: N, decay: N) -> N {
    kinetic + rise / speed2.mul_add(decay, N::splat(1.0))
}

/// Friction on a contact that would slide at `axial` and `around` without it, N, in the direction
/// of these velocities (the string feels the opposite).
///
/// `limit` is `μ N`; `g_axial` and `g_around` are the speeds that one newton removes in the step.
/// The law is `f_i (g_i + λ) = u_i` with `λ = |u|/limit − Σ g u²/Σ u² ≥ 0`; the length of `f` is
/// the limit, or the value that stops the motion if that is less. Theory and error of the
/// direction: `docs/src/theory/friction.md`.
#[inline(always)]
pub fn vector<N: Number>(limit: N, axial: N, around: N, g_axial: N, g_around: N) -> (N, N) {
    let (a2, t2) = (axial * axial, around * around);
    let u2 = a2 + t2;
    // Everything times limit · |u|², which spares the divisions.
    let scale = limit * u2;
    let weighted = g_axial.mul_add(a2, g_around * t2);
    let slide = limit.neg_mul_add(weighted, u2 * u2.sqrt()).max(N::zero());
    let wa = axial * g_around.mul_add(scale, slide);
    let wt = around * g_axial.mul_add(scale, slide);
    let stop = limit * scale * (g_axial * g_around);
    let length = wa.mul_add(wa, wt * wt).sqrt();
    let ratio = limit / (length.max(stop) + N::splat(N::TINY));
    (wa * ratio, wt * ratio)
}

/// The article's (9) and (11), one direction of them: the full limit against this direction's own
/// velocity, capped at the value that stops it. Arguments as for [`vector`].
#[inline(always)]
pub fn independent<N: Number>(limit: N, velocity: N, g: N) -> N {
    (velocity / g).min(limit).max(-limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where it slides, the friction is on Coulomb's cone and against the remaining velocity; where
    /// it can stick, nothing remains. Far from sticking (`λ/g > 100`) the direction holds to 1e-4
    /// by its cosine, which has no finer rounding.
    #[test]
    fn vector_friction_obeys_coulomb() {
        let (ga, gt) = (4e-6, 9e-6);
        for speed in [1e-6, 1e-4, 1e-3, 1e-2, 1.0, 30.0] {
            for angle in [0.0f64, 0.01, 0.3, 0.8, 1.2, std::f64::consts::FRAC_PI_2] {
                for limit in [0.0, 1.0, 100.0, 3000.0] {
                    let (ua, ut) = (speed * angle.sin(), speed * angle.cos());
                    let (fa, ft) = vector(limit, ua, ut, ga, gt);
                    let (ra, rt) = (ua - ga * fa, ut - gt * ft);
                    let (f, rest) = (fa.hypot(ft), ra.hypot(rt));
                    assert!(f <= limit * (1.0 + 1e-12));
                    if (ua / ga).hypot(ut / gt) <= limit {
                        assert!(rest <= 1e-12 * speed, "does not stick: {rest}");
                    } else if limit > 0.0 {
                        let sliding = rest / limit / gt;
                        assert!(f >= limit * (1.0 - 1e-9) || sliding < 1.0);
                        if sliding > 100.0 {
                            let cosine = (fa * ra + ft * rt) / (f * rest);
                            assert!(cosine > 1.0 - 1e-8, "{cosine}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn independent_friction_stops_each_direction() {
        assert_eq!(independent(100.0, 1e-5, 4e-6), 1e-5 / 4e-6);
        assert_eq!(independent(100.0, 1.0, 9e-6), 100.0);
        assert_eq!(independent(100.0, -1.0, 9e-6), -100.0);
    }

    #[test]
    fn coefficient_decays_from_rest_to_kinetic() {
        let decay = STRIBECK_SPEED_M_PER_S.powi(-2);
        assert_eq!(coefficient(0.3, 0.1, 0.0, decay), 0.4);
        assert!((coefficient(0.3, 0.1, 0.01, decay) - 0.35).abs() < 1e-15);
        assert!((coefficient(0.3, 0.1, 1e4, decay) - 0.3).abs() < 1e-6);
    }
}
