//! Friction: the cone against its own implicit law, solved exactly.

use wholestring::internals::{independent, vector};

use crate::random::Random;

/// Coulomb's law at the end of the step: `f_i (g_i + λ) = u_i`, `|f| = limit`, by bisection of λ;
/// the force that stops the motion where that is less than the limit.
fn exact(limit: f64, u: [f64; 2], g: [f64; 2]) -> ([f64; 2], f64) {
    let at = |lambda: f64| [u[0] / (g[0] + lambda), u[1] / (g[1] + lambda)];
    let length = |f: [f64; 2]| f[0].hypot(f[1]);
    if length(at(0.0)) <= limit {
        return (at(0.0), 0.0);
    }
    let (mut low, mut high) = (0.0, u[0].hypot(u[1]) / limit);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if length(at(middle)) > limit { low = middle } else { high = middle }
    }
    (at(high), high)
}

/// Largest error of the direction, rad, and of the length over the limit, where `g` about and along
/// the hole differ by up to `ratio` and `λ` over the larger of them is between `from` and `to`.
fn worst(ratio: f64, from: f64, to: f64) -> (f64, f64) {
    let mut random = Random(11);
    let (mut direction, mut length): (f64, f64) = (0.0, 0.0);
    for _ in 0..50_000 {
        let other = ratio.powf(random.between(-1.0, 1.0));
        let g = [5e-6, 5e-6 * other];
        let limit = 10f64.powf(random.between(-1.0, 5.0));
        // A point of the law, a force on the cone and the remaining speed, converted back to the
        // speed without friction: no neighbourhood of rest is left out.
        let angle = random.between(0.0, std::f64::consts::TAU);
        let lambda =
            g[0].max(g[1]) * (from.ln() + random.between(0.0, 1.0) * (to / from).ln()).exp();
        let f = [limit * angle.cos(), limit * angle.sin()];
        let u = [f[0] * (g[0] + lambda), f[1] * (g[1] + lambda)];
        let found = vector(limit, u[0], u[1], g[0], g[1]);
        let size = found.0.hypot(found.1);
        length = length.max((size / limit - 1.0).abs());
        let cross = (found.0 * f[1] - found.1 * f[0]) / (size * limit);
        direction = direction.max(cross.asin().abs());
    }
    (direction, length)
}

/// The approximate cone against the exact one. Its length is exact. Its direction is off where the
/// contact almost stops within the step and `g` about the hole is not that along it: by 11° at the
/// very worst for a ratio of 4, which strings stay below (`1 + m r²/J` of a tube on its joints, mud
/// included), at `λ = g/5`, when a fifth of the speed that a step can remove is left. The bounds
/// are 1.2 times the measured values; they fall with the third power of `g/λ`, as the second-order
/// expansion should.
#[test]
fn the_cone_is_exact_but_for_its_direction_near_rest() {
    for (ratio, from, to, bound) in [
        (2.0, 1e-6, 1.0, 0.054),
        (2.0, 1.0, 10.0, 5.3e-3),
        (4.0, 1e-6, 1.0, 0.24),
        (4.0, 1.0, 10.0, 0.025),
        (4.0, 10.0, 100.0, 7.6e-5),
        (4.0, 100.0, 1e4, 1e-7),
        (10.0, 10.0, 100.0, 1.4e-4),
    ] {
        let (direction, length) = worst(ratio, from, to);
        assert!(direction < bound, "{ratio} {from}: {direction:e}");
        assert!(length < 1e-12);
    }
}

/// Rest is exact: a contact that can stick is stopped to rounding, up to the very limit.
#[test]
fn a_contact_that_can_stick_is_stopped() {
    let mut random = Random(12);
    for _ in 0..100_000 {
        let g = [10f64.powf(random.between(-7.0, -4.0)), 10f64.powf(random.between(-7.0, -4.0))];
        let limit = 10f64.powf(random.between(-3.0, 5.0));
        let angle = random.between(0.0, std::f64::consts::TAU);
        let part =
            if random.between(0.0, 1.0) < 0.2 { 1.0 - 1e-9 } else { random.between(0.0, 1.0) };
        let u = [part * limit * g[0] * angle.cos(), part * limit * g[1] * angle.sin()];
        let f = vector(limit, u[0], u[1], g[0], g[1]);
        let rest = (u[0] - g[0] * f.0).abs() + (u[1] - g[1] * f.1).abs();
        let (stop, lambda) = exact(limit, u, g);
        assert_eq!(lambda, 0.0);
        assert!(rest <= 1e-12 * (u[0].abs() + u[1].abs()), "{rest:e} of {u:?}: {f:?} {stop:?}");
    }
}

/// Whatever the contact, friction works against the mean of the speeds before and after it, never
/// exceeds its limit and never reverses a motion.
#[test]
fn friction_only_takes_energy() {
    let mut random = Random(13);
    let mut reversal: f64 = 0.0;
    for _ in 0..300_000 {
        let g = [10f64.powf(random.between(-8.0, -3.0)), 10f64.powf(random.between(-8.0, -3.0))];
        let limit = 10f64.powf(random.between(-6.0, 6.0));
        let scale = 10f64.powf(random.between(-3.0, 4.0));
        let angle = random.between(0.0, std::f64::consts::TAU);
        // Near the force that stops it, and far beyond.
        let u = [scale * limit * g[0] * angle.cos(), scale * limit * g[1] * angle.sin()];
        for f in [
            vector(limit, u[0], u[1], g[0], g[1]),
            (independent(limit, u[0], g[0]), independent(limit, u[1], g[1])),
        ] {
            let work = f.0 * (u[0] - 0.5 * g[0] * f.0) + f.1 * (u[1] - 0.5 * g[1] * f.1);
            assert!(work >= 0.0, "{work:e}: u {u:?} g {g:?} limit {limit}: {f:?}");
        }
        let f = vector(limit, u[0], u[1], g[0], g[1]);
        assert!(f.0.hypot(f.1) <= limit * (1.0 + 1e-12));
        for (f, (u, g)) in [f.0, f.1].into_iter().zip(u.into_iter().zip(g)) {
            reversal = reversal.max(g * f / u - 1.0);
        }
    }
    // No part of the motion is reversed.
    assert!(reversal < 1e-12, "{reversal:e}");
}

#[test]
fn no_speed_and_no_force_are_no_trouble() {
    for (limit, u) in
        [(0.0, [1.0, 1.0]), (100.0, [0.0, 0.0]), (0.0, [0.0, 0.0]), (1e-200, [1e-200, 0.0])]
    {
        let f: (f64, f64) = vector(limit, u[0], u[1], 1e-30, 9e-6);
        assert!(f.0.is_finite() && f.1.is_finite() && f.0.hypot(f.1) <= limit, "{f:?}");
    }
}
