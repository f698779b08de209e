use std::f64::consts::TAU;

use super::*;
use crate::random::Random;

const SAMPLES: usize = 512;

/// Series of each kind: averages are taken over this number.
const SERIES: usize = 400;

/// Normal numbers whose autocorrelation falls by `e` in `time` samples: `x' = a x + √(1 − a²) ξ`,
/// `a = e^(−1/time)`. White noise where it is zero.
fn correlated(random: &mut Random, time: f64, samples: usize) -> Vec<f64> {
    let a = if time > 0.0 { (-1.0 / time).exp() } else { 0.0 };
    let mut normal = || {
        // Box and Muller; the logarithm of zero is kept out.
        let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        radius * (TAU * random.unit()).cos()
    };
    let mut x = normal();
    (0..samples)
        .map(|_| {
            x = a * x + (1.0 - a * a).sqrt() * normal();
            x
        })
        .collect()
}

/// The standard error of the mean of such numbers, exactly:
/// `σ²/n · ((1 + a)/(1 − a) − 2a(1 − aⁿ)/(n (1 − a)²))`.
fn exact_error(time: f64, samples: usize) -> f64 {
    let a = if time > 0.0 { (-1.0 / time).exp() } else { 0.0 };
    let n = samples as f64;
    let bracket = (1.0 + a) / (1.0 - a) - 2.0 * a * (1.0 - a.powf(n)) / (n * (1.0 - a).powi(2));
    (bracket / n).sqrt()
}

/// Its mean over many series is that of the closed form. The largest of seven estimates, the last
/// of which knows its own to `1/√14`, is above it by an eighth where nothing is correlated; blocks
/// of an eighth of the stretch fall short where the correlation time nears them, by a ninth at a
/// fiftieth of it. 15 % holds both, and `s/√n` of the samples would be short by `√(2 time)`.
#[test]
fn the_standard_error_is_that_of_the_closed_form() {
    let mut random = Random::new(7);
    for time in [0.0, 2.0, 5.0, 10.0] {
        let found = (0..SERIES)
            .map(|_| standard_error(&correlated(&mut random, time, SAMPLES)))
            .sum::<f64>()
            / SERIES as f64;
        let ratio = found / exact_error(time, SAMPLES);
        assert!((0.85..1.15).contains(&ratio), "{time}: {ratio}");
    }
}

/// Of four hundred stretches without drift hardly one is reported to drift: four standard errors
/// leave one in 16 000 of a normal variable, and one in a hundred where the error itself is known
/// from eight blocks and the samples remember a fiftieth of the stretch.
#[test]
fn what_stands_still_does_not_drift() {
    let mut random = Random::new(3);
    for (time, most) in [(0.0, 0.005), (2.0, 0.01), (5.0, 0.015), (10.0, 0.03)] {
        let false_ones = (0..SERIES)
            .filter(|_| Drift::of(&correlated(&mut random, time, SAMPLES)).errors > SIGNIFICANT)
            .count();
        let part = false_ones as f64 / SERIES as f64;
        assert!(part <= most, "{time}: {part}");
    }
}

/// A ramp under noise: the line's change is the ramp's within four of its standard errors
/// `√(12/n) σ`, and it shows as soon as it is well beyond them.
#[test]
fn a_ramp_is_found_with_its_height() {
    let mut random = Random::new(5);
    for height in [2.0, -5.0, 40.0] {
        let mut samples = correlated(&mut random, 0.0, SAMPLES);
        for (i, x) in samples.iter_mut().enumerate() {
            *x += height * i as f64 / SAMPLES as f64;
        }
        let drift = Drift::of(&samples);
        let error = (12.0 / SAMPLES as f64).sqrt();
        assert!((drift.change - height).abs() < 4.0 * error, "{drift:?}");
        let exceeds = |part: f64| drift.exceeds(SIGNIFICANT, part * height.abs());
        assert!(exceeds(0.5) && !exceeds(2.0), "{drift:?}");
    }
}

/// A start that fades within the stretch, from a twentieth of it to thrice as long as it, under
/// noise of a thousandth: its line is that of the integral, `12 τ² e₁ − 6 τ e₀` with
/// `e₀ = 1 − e^(−1/τ)` and `e₁ = 1 − (1 + 1/τ) e^(−1/τ)`, as `12 ∫ (t − ½) e^(−t/τ) dt`.
#[test]
fn a_start_that_fades_is_found() {
    let mut random = Random::new(9);
    for tau in [0.05, 0.1, 0.2, 0.5, 1.0, 3.0] {
        let mut samples = correlated(&mut random, 0.0, SAMPLES);
        for (i, x) in samples.iter_mut().enumerate() {
            let t = (i as f64 + 0.5) / SAMPLES as f64;
            *x = 1e-3 * *x + (-t / tau).exp();
        }
        let drift = Drift::of(&samples);
        let left = (-1.0 / tau).exp();
        let expected =
            12.0 * tau * tau * (1.0 - (1.0 + 1.0 / tau) * left) - 6.0 * tau * (1.0 - left);
        // Noise: 4 √(12/n) 1e-3; sums for the integral: (h/τ)²/24 of it, at most 1e-4.
        assert!((drift.change - expected).abs() < 1e-3, "{tau}: {drift:?}, {expected}");
        assert!(drift.errors > SIGNIFICANT, "{tau}: {drift:?}");
    }
}

/// Stick-slip is a steady state: a swing with noise on it does not drift by two standard errors,
/// whatever its phase, from two periods in the stretch on; and the mean of a swing is known to its
/// amplitude over the number of its half periods at worst.
#[test]
fn a_swing_stands_still() {
    let mut random = Random::new(11);
    for periods in [2.0, 2.5, 3.0, 3.3, 4.0, 6.5, 20.0] {
        for phase in 0..24 {
            let noise = correlated(&mut random, 1.0, SAMPLES);
            let swing = |i: usize| {
                (TAU * (periods * i as f64 / SAMPLES as f64 + f64::from(phase) / 24.0)).sin()
            };
            let samples: Vec<f64> = (0..SAMPLES).map(|i| swing(i) + 0.05 * noise[i]).collect();
            let drift = Drift::of(&samples);
            assert!(drift.errors < 2.0, "{periods} periods, phase {phase}: {drift:?}");
            assert!(standard_error(&samples) < 1.0 / (2.0 * periods).sqrt());
        }
    }
}

#[test]
fn few_samples_are_not_judged() {
    assert_eq!(standard_error(&[]), 0.0);
    assert_eq!(standard_error(&[3.0]), 0.0);
    // `s/√n` of two: half their difference.
    assert!((standard_error(&[1.0, 3.0]) - 1.0).abs() < 1e-15);
    let few = Drift::of(&[1.0, 2.0, 3.0, 4.0]);
    assert!((few.change - 4.0).abs() < 1e-15 && few.errors == 0.0);
    assert_eq!(Drift::of(&[]).change, 0.0);
}
