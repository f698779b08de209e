//! The noise itself.

use super::*;

const ROUGH: Excitation = Excitation {
    lobes: 0,
    amplitude_m: 0.0,
    roughness_m: 2e-3,
    torque_fluctuation: 0.1,
    band: Band::PerRevolution(8.0),
};

/// The front at `count` angles, evenly spaced by `step_rad`.
fn fronts(shaker: &Shaker, count: usize, step_rad: f64) -> Vec<f64> {
    (0..count).map(|i| shaker.next(step_rad * i as f64, 0.0).front_m).collect()
}

fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

/// Over 10 000 revolutions, 350 000 knots, the front's rms is the one that was requested. The mean
/// square of so many knots scatters by `√(2·1.4/350 000)`, 0.3 % of itself: the rms is within 0.5 %
/// three times over.
#[test]
fn roughness_has_the_rms_that_was_asked_for() {
    for seed in [1, 2, 77] {
        let shaker = Shaker::new(ROUGH, seed);
        let front = fronts(&shaker, 500_000, 10_000.0 * std::f64::consts::TAU / 500_000.0);
        let found = rms(&front) / 2e-3;
        assert!((found - 1.0).abs() < 5e-3, "{found}");
        let mean = front.iter().sum::<f64>() / front.len() as f64;
        assert!(mean.abs() < 1e-2 * 2e-3, "{mean}");
    }
}

/// Its power density at the band's end is half of that at its beginning, and a hundredth part is
/// left at two and a half times the band: `sinc⁸`.
#[test]
fn power_falls_to_half_at_the_band() {
    let shaker = Shaker::new(ROUGH, 5);
    // Segments of 64 revolutions, 64 samples in each.
    let segments: Vec<Vec<f64>> = (0..1000)
        .map(|s| {
            let samples = 64 * s..64 * (s + 1);
            let at = |turns: f64| shaker.next(turns * std::f64::consts::TAU, 0.0).front_m;
            samples
                .flat_map(|turn| (0..64).map(move |i| f64::from(turn) + f64::from(i) / 64.0))
                .map(at)
                .collect()
        })
        .collect();
    // Power in the 17 lines, 1/64 of a wave per revolution apart, around so many waves.
    let density = |waves: f64| {
        let mut sum = 0.0;
        for line in -8..=8 {
            let step = (waves + f64::from(line) / 64.0) * std::f64::consts::TAU / 64.0;
            let phases: Vec<(f64, f64)> =
                (0..4096).map(|i| (step * f64::from(i)).sin_cos()).collect();
            for segment in &segments {
                let (mut re, mut im) = (0.0, 0.0);
                for (front, (sin, cos)) in segment.iter().zip(&phases) {
                    re += front * cos;
                    im += front * sin;
                }
                sum += re * re + im * im;
            }
        }
        sum
    };
    let low = density(0.5);
    // 1000 x 17 independent lines scatter by 0.8 % each.
    let half = density(8.0) / low;
    assert!((half - 0.5).abs() < 0.02, "{half}");
    let x = std::f64::consts::PI * KNOT_SPACING * 2.5;
    let far = density(20.0) / low / (x.sin() / x).powi(8);
    assert!((far - 1.0).abs() < 0.04, "{far}");
}

/// The noise is smooth: twice continuously differentiable, so that nothing hits the bit.
#[test]
fn the_noise_is_smooth() {
    let shaker = Shaker::new(ROUGH, 3);
    let knot = std::f64::consts::TAU / 8.0 * KNOT_SPACING;
    let h = 1e-3;
    let front = |knots: f64| shaker.next(knots * knot, 0.0).front_m;
    let slope = |x: f64| (front(x + h) - front(x - h)) / (2.0 * h);
    let bend = |x: f64| (front(x + h) - 2.0 * front(x) + front(x - h)) / (h * h);
    for k in 0..200 {
        let x = f64::from(k);
        assert!((front(x + 1e-9) - front(x - 1e-9)).abs() < 1e-10);
        // A jump would be of the order of the roughness, 2e-3.
        assert!((slope(x + h) - slope(x - h)).abs() < 4e-5, "{k}");
        assert!((bend(x + 2.0 * h) - bend(x - 2.0 * h)).abs() < 8e-5, "{k}");
    }
}

/// The same seed is the same bottom, wherever one comes from; another seed another one; the
/// torque's noise is neither.
#[test]
fn a_seed_is_a_bottom() {
    let here = Shaker::new(ROUGH, 9);
    let mut there = Shaker::new(ROUGH, 9);
    for _ in 0..8 {
        there.advance(0.25, 1e-3);
    }
    there.advance(-1.0, 1e-3);
    assert_eq!(here.next(1.5, 0.0).front_m, there.next(0.5, 0.0).front_m);
    let other = Shaker::new(ROUGH, 10);
    let correlation = |a: &dyn Fn(f64) -> f64, b: &dyn Fn(f64) -> f64| {
        let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
        for i in 0..100_000 {
            let x = 0.1 * f64::from(i);
            let (a, b) = (a(x), b(x));
            ab += a * b;
            aa += a * a;
            bb += b * b;
        }
        ab / (aa * bb).sqrt()
    };
    let front = |x: f64| here.next(x, 0.0).front_m;
    // 50 000 knots: correlations by chance are below 0.02.
    assert!(correlation(&front, &|x| other.next(x, 0.0).front_m).abs() < 0.02);
    assert!(correlation(&front, &|x| here.next(x, 0.0).torque).abs() < 0.02);
}

/// In time, the noise continues while the bit is stationary, and rotation has no influence.
#[test]
fn noise_in_time_needs_no_rotation() {
    let shaker = Shaker::new(Excitation { band: Band::PerSecond(5.0), ..ROUGH }, 1);
    assert_eq!(shaker.next(0.0, 0.3).front_m, shaker.next(7.0, 0.3).front_m);
    let front: Vec<f64> =
        (0..400_000).map(|i| shaker.next(0.0, 0.01 * f64::from(i)).front_m).collect();
    // 88 000 knots: the rms scatters by 0.3 %.
    let found = rms(&front) / 2e-3;
    assert!((found - 1.0).abs() < 1e-2, "{found}");
}
