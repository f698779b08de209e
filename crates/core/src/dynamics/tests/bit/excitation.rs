//! The rate law's bit on a bottom that shakes it.

use std::f64::consts::TAU;

use super::*;
use crate::{
    common::SMOOTH,
    dynamics::boundary::bit::{Band, BitLaw, Excitation, RateLaw},
};

const SPIN: f64 = 7.0;

const EVEN: Excitation = Excitation { lobes: 0, ..SMOOTH };

fn settings(excitation: Option<Excitation>) -> BitSettings {
    BitSettings {
        law: BitLaw::Rate(RateLaw { rock_stiffness_N_per_m: 1e8, excitation }),
        ..BitSettings::default()
    }
}

/// A bit that moves down at the rate of penetration and turns at its speed, whatever the rock does.
fn led(excitation: Excitation) -> Rig {
    let mut rig = Rig::with(OPERATION, settings(Some(excitation)));
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    node!(rig.chain, 0, inv_polar = 0.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, 0.003));
    rig.set_spin(SPIN);
    rig
}

/// Amplitude of `values` at so many waves per sample.
fn line(values: &[f64], waves_per_sample: f64) -> f64 {
    let (mut re, mut im) = (0.0, 0.0);
    for (i, v) in values.iter().enumerate() {
        let angle = TAU * waves_per_sample * i as f64;
        re += v * angle.cos();
        im += v * angle.sin();
    }
    2.0 * re.hypot(im) / values.len() as f64
}

/// Three lobes show in the weight on bit at three times the rotary speed and nowhere else. Rock is
/// a spring `k` and a dashpot `W₀/v₀` in a row: the amplitude is `k A ω/√(ω² + (k v₀/W₀)²)`.
#[test]
fn lobes_show_at_their_multiple_of_the_speed() {
    let amplitude = 0.1e-3;
    let mut rig = led(Excitation { lobes: 3, amplitude_m: amplitude, ..EVEN });
    let dt = TAU / SPIN / 4000.0;
    for _ in 0..12_000 {
        rig.step(dt);
    }
    let weights: Vec<f64> = (0..80_000).map(|_| rig.step(dt).weight_on_bit_N).collect();
    let omega = 3.0 * SPIN;
    let yielding = 1e8 * 0.003 / 60e3;
    let expected = 1e8 * amplitude * omega / omega.hypot(yielding);
    // The front's advance is implicit: first order in (k v₀/W₀) dt = 1e-3.
    let found = line(&weights, 3.0 / 4000.0);
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    for waves in [1.0, 2.0, 4.0, 5.0, 6.0, 9.0] {
        let found = line(&weights, waves / 4000.0);
        assert!(found < 1e-3 * expected, "{waves} {found}");
    }
    // The rock yields as it did on a smooth bottom.
    let mean = weights.iter().sum::<f64>() / weights.len() as f64;
    assert!((mean / 60e3 - 1.0).abs() < 1e-3, "{mean}");
}

/// On rock that hardly yields a rough bottom's weight has the roughness' rms times the stiffness,
/// and the torque fluctuates by the fraction that was requested.
#[test]
fn roughness_shows_in_weight_and_torque() {
    let operation = OPERATION.rate_of_penetration_m_per_s(1e-6);
    let rough = Excitation { roughness_m: 0.1e-3, torque_fluctuation: 0.2, ..EVEN };
    let mut rig = Rig::with(operation, settings(Some(rough)));
    node!(rig.chain, 0, inv_mass_axial = 0.0);
    node!(rig.chain, 0, inv_polar = 0.0);
    rig.chain.set_velocity(0, Vector(0.0, 0.0, 1e-6));
    rig.set_spin(SPIN);
    let n = 2_000_000;
    let (mut w, mut ww, mut q, mut qq) = (0.0, 0.0, 0.0, 0.0);
    for _ in 0..n {
        let step = rig.step(2e-3);
        w += step.weight_on_bit_N;
        ww += step.weight_on_bit_N.powi(2);
        let ratio = step.torque_N_m / (0.05 * step.weight_on_bit_N);
        q += ratio;
        qq += ratio * ratio;
    }
    let n = f64::from(n);
    let rms = |sum: f64, squares: f64| (squares / n - (sum / n).powi(2)).sqrt();
    // 4450 revolutions, 156 000 knots: 0.3 % by chance; the yielding takes (k v₀/W₀ / 8 Ω)² and
    // less.
    assert!((rms(w, ww) / 10e3 - 1.0).abs() < 0.02, "{}", rms(w, ww));
    assert!((rms(q, qq) / 0.2 - 1.0).abs() < 0.02, "{}", rms(q, qq));
    assert!((q / n - 1.0).abs() < 5e-3);
}

/// Off is off: an excitation without amplitude gives the bits of none.
#[test]
fn without_amplitude_nothing_changes() {
    let mut rigs = [None, Some(EVEN)].map(|e| Rig::with(OPERATION, settings(e)));
    for rig in &mut rigs {
        rig.push = Vector(0.0, 0.0, 60e3);
        rig.turn = 3.2e3;
        rig.set_spin(SPIN);
    }
    for _ in 0..5000 {
        let [a, b] = [rigs[0].step(5e-4), rigs[1].step(5e-4)];
        assert_eq!(a.weight_on_bit_N.to_bits(), b.weight_on_bit_N.to_bits());
        assert_eq!(a.torque_N_m.to_bits(), b.torque_N_m.to_bits());
    }
}

/// A heavy bit on a rough bottom: half the step, the same motion, the difference falling with the
/// step.
#[test]
fn the_step_does_not_change_the_bottom() {
    let weights = |steps_per_ms: usize| {
        let mut rig = Rig::with(
            OPERATION,
            settings(Some(Excitation {
                lobes: 3,
                amplitude_m: 0.05e-3,
                roughness_m: 0.1e-3,
                ..EVEN
            })),
        );
        node!(rig.chain, 0, inv_mass_axial = 1e-4);
        node!(rig.chain, 0, inv_polar = 0.0);
        rig.set_spin(SPIN);
        let mut weights = Vec::new();
        for i in 0..5000 * steps_per_ms {
            // The push consists of a weight and a dashpot, so no oscillation lasts.
            let damped = rig.chain.velocity(0).2 - 0.003;
            rig.push = Vector(0.0, 0.0, (60e3 - 2e5 * damped) * 1e-4 * MASS_KG);
            let step = rig.step(1e-3 / steps_per_ms as f64);
            if (i + 1) % steps_per_ms == 0 {
                weights.push(step.weight_on_bit_N);
            }
        }
        weights
    };
    let finest = weights(32);
    let apart = |series: &[f64]| {
        let sum: f64 = series.iter().zip(&finest).map(|(a, b)| (a - b).powi(2)).sum();
        (sum / finest.len() as f64).sqrt()
    };
    let mean = finest.iter().sum::<f64>() / finest.len() as f64;
    let spread =
        (finest.iter().map(|w| (w - mean).powi(2)).sum::<f64>() / finest.len() as f64).sqrt();
    let [coarse, fine] = [apart(&weights(4)), apart(&weights(8))];
    assert!(spread > 3e3, "{spread}");
    assert!(coarse < 0.1 * spread, "{coarse} {spread}");
    // First order: (1/4 - 1/32) over (1/8 - 1/32) is 2.33.
    assert!((2.0..2.8).contains(&(coarse / fine)), "{coarse} {fine}");
}

/// The moving front does work, and it is booked.
#[test]
fn a_rough_bottom_keeps_the_books() {
    let rough = Excitation {
        amplitude_m: 0.5e-3,
        roughness_m: 0.5e-3,
        torque_fluctuation: 0.3,
        band: Band::PerSecond(50.0),
        ..SMOOTH
    };
    let mut rig = Rig::with(OPERATION, settings(Some(rough)));
    assert_work_is_the_change_of_energy(&mut rig);
}
