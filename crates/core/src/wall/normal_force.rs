//! The contact force of a node within a step: [both laws](super::contact) at the step's end.

use crate::simd::number::Number;

/// `N = K α^1.5 (1 + d v_n)` at the end of a step that, without contact, would end at penetration
/// `alpha`, approaching at `v_n`. One newton takes `give`, `dt²/m`, of `alpha` away. The
/// approach is the one without contact, not that of the step's end.
///
/// The force is `β³` times that without the node's motion in the step, `β² + r β³ = 1` with `r = K
/// (1 + d v_n) (dt²/m) √α`; a rational function fits `β³` within 3e-6 for `r < 60`. `d` is never
/// allowed to pull. Theory: `docs/src/theory/wall.md`.
#[inline(always)]
pub fn hertz<N: Number>(alpha: N, v_n: N, stiffness: N, dissipation: N, give: N) -> N {
    let one = N::splat(1.0);
    let alpha = alpha.max(N::zero());
    let k = stiffness * dissipation.mul_add(v_n, one).max(N::zero());
    let s = k * alpha.sqrt();
    let r = s * give;
    s * alpha * (polynomial(&ABOVE, r) / polynomial(&BELOW, r))
}

/// Coefficients of the rational fit of `β³`, from the highest power down: the least largest
/// relative error on 800 points of `0 < r < 60`, found by reweighted least squares.
const ABOVE: [f64; 5] = [
    1.462_374_706_377_161_2e-3,
    1.040_899_064_463_644_8e-1,
    1.054_749_287_974_43,
    2.214_234_169_115_530_7,
    9.999_977_039_408_562e-1,
];
const BELOW: [f64; 6] = [
    1.476_084_544_026_804_8e-3,
    1.120_430_328_325_463_8e-1,
    1.337_769_535_006_785,
    4.004_257_394_565_942_5,
    3.714_011_052_190_117_7,
    1.0,
];

#[inline(always)]
fn polynomial<N: Number, const TERMS: usize>(coefficients: &[f64; TERMS], x: N) -> N {
    let mut sum = N::splat(coefficients[0]);
    for c in &coefficients[1..] {
        sum = sum.mul_add(x, N::splat(*c));
    }
    sum
}

/// `N = max(0, k α + c v_n)` while the surfaces overlap, at the end of the step `dt` of a node to
/// which one newton gives `mobility`, `dt/m`, of speed.
#[inline(always)]
pub fn linear<N: Number>(alpha: N, v_n: N, k: N, c: N, mobility: N, dt: N) -> N {
    let free = k.mul_add(alpha, c * v_n);
    let force = free / mobility.mul_add(k.mul_add(dt, c), N::splat(1.0));
    alpha.if_positive(force.max(N::zero()), N::zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The force is that of the root of its cubic, found by halving, for every stiffness and depth
    /// of a contact. The tolerance is that of its fit (see [`hertz`]).
    #[test]
    fn hertz_solves_its_cubic() {
        let inertia = 150.0 / 3e-7;
        // K end^1.5 falls from K α^1.5 to none while (α − end) m/dt² grows from none.
        let exact = |alpha: f64, k: f64| {
            let (mut low, mut high) = (0.0, alpha);
            for _ in 0..200 {
                let end = 0.5 * (low + high);
                if k * f64::powf(end, 1.5) > (alpha - end) * inertia {
                    high = end;
                } else {
                    low = end;
                }
            }
            k * f64::powf(low, 1.5)
        };
        let mut solved = 0;
        for exponent in -12..=0 {
            for k in [1e6, 1e9, 1e11, 2e12] {
                let alpha = 10f64.powi(exponent);
                let n = hertz(alpha, 0.0, k, 0.5, 1.0 / inertia);
                let end = alpha - n / inertia;
                assert!(n > 0.0 && end >= 0.0);
                if k * alpha.sqrt() / inertia < 60.0 {
                    let law = exact(alpha, k);
                    assert!((n / law - 1.0).abs() < 3e-6, "alpha {alpha} k {k}: {law} {n}");
                    solved += 1;
                }
            }
        }
        assert!(solved > 30);
    }

    #[test]
    fn nothing_pulls() {
        assert_eq!(hertz(-1e-3, 1.0, 1e11, 0.5, 1e-9), 0.0);
        assert_eq!(hertz(1e-6, -10.0, 1e11, 0.5, 1e-9), 0.0);
        assert_eq!(linear(-1e-6, 1.0, 1e7, 1e4, 5e-4 / 200.0, 5e-4), 0.0);
        assert_eq!(linear(1e-6, -10.0, 1e7, 1e4, 5e-4 / 200.0, 5e-4), 0.0);
    }
}
