use std::f64::consts::TAU;

use super::*;
use crate::{
    outcome::{DriftScale, varying_place},
    random::Random,
};

const INTERVAL_S: f64 = 0.01;
const LENGTH_M: f64 = 3000.0;
const HOOK_LOAD_N: f64 = 300e3;

/// Change of the hook load per metre that the bit moves down the hole, N.
const HOOK_LOAD_PER_M: f64 = -500.0;

fn settling() -> Settling {
    let mut per_metre = [0.0; VARYING.len()];
    per_metre[varying_place("hook_load_N")] = HOOK_LOAD_PER_M;
    Settling::UntilSteady { stretch_s: 5.0, min_s: 10.0, max_s: 120.0, per_metre }
}

/// End of the settling of a string with this hook load against time, plus a noise of 100 N; the bit
/// goes down at a speed, m/s.
fn ends(hook_load_N: impl Fn(f64) -> f64, speed_m_per_s: f64, duration_s: f64) -> Option<Settled> {
    let settling = settling();
    let mut random = Random::new(2);
    let mut series = TimeSeries::default();
    for sample in 1..=12_001 {
        if let Some(settled) = settling.ends(&series, INTERVAL_S, duration_s, LENGTH_M) {
            return Some(settled);
        }
        let time_s = f64::from(sample) * INTERVAL_S;
        series.time_s.push(time_s);
        series.hook_load_N.push(hook_load_N(time_s) + 100.0 * random.signed());
        series.bit_depth_m.push(speed_m_per_s * time_s);
    }
    None
}

/// A start that fades as `A e^(−t/τ)`: the line through the last `L` changes by
/// `A e^(−t/τ) f(τ/L)`, `f(x) = 12 x² (e^(1/x) − 1) − 6 x (e^(1/x) + 1)` from its integral, and the
/// window begins with the first look at which that is below a tenth of a percent of the hook load
/// in a window as long as the stretch: a second later at most, and another for the noise.
#[test]
fn a_start_that_fades_is_waited_for() {
    for (amplitude_N, tau_s) in [(30e3, 4.0), (-30e3, 8.0), (100e3, 8.0), (3e3, 20.0)] {
        let settled = ends(|t| HOOK_LOAD_N + amplitude_N * (-t / tau_s).exp(), 0.0, 5.0);
        let settled = settled.expect("it ends");
        let x: f64 = tau_s / 5.0;
        let grown = (1.0 / x).exp();
        let f = 12.0 * x * x * (grown - 1.0) - 6.0 * x * (grown + 1.0);
        let expected_s = tau_s * (amplitude_N * f / (1e-3 * HOOK_LOAD_N)).abs().ln();
        let expected_s = expected_s.max(10.0);
        assert!(settled.steady);
        let late_s = settled.settle_s - expected_s;
        assert!(
            (-1.0..=1.0 + INTERVAL_S * 1.5).contains(&late_s),
            "{tau_s}: {settled:?}, {expected_s}"
        );
    }
}

/// A longer window drifts by more: twelve times as long, it is waited for until a twelfth is left,
/// `τ ln 12` later.
#[test]
fn a_longer_window_waits_longer() {
    let fading = |t: f64| HOOK_LOAD_N + 100e3 * (-t / 8.0).exp();
    let [short, long] = [5.0, 60.0].map(|duration_s| ends(fading, 0.0, duration_s).unwrap());
    let later_s = long.settle_s - short.settle_s;
    // The noise hides the very last of it: 25 N of the line of a stretch of 500 samples of ±100 N,
    // `4 √(12/500) 100 N/√3` is 36 N.
    assert!(long.steady && later_s > 13.0 && later_s < 8.0 * 12_f64.ln() + 2.0, "{later_s}");
}

/// Stick-slip and whirl are steady states: a swing of a fifth of the hook load ends settling with
/// the first look.
#[test]
fn a_limit_cycle_is_steady() {
    for period_s in [0.4, 1.0, 2.3] {
        let settled = ends(|t| HOOK_LOAD_N + 60e3 * (TAU * t / period_s).sin(), 0.0, 60.0);
        let settled = settled.expect("it ends");
        assert!(settled.steady && (settled.settle_s - 10.01).abs() < 1e-9, "{settled:?}");
    }
}

/// A vibration that builds up around the same mean, by `e` in 5 s until 25 s, is waited for: until
/// it has been as large as it gets for most of a stretch of 5 s, and a look more.
#[test]
fn a_vibration_that_builds_up_is_waited_for() {
    for period_s in [0.4, 0.7, 1.0] {
        let growing = |t: f64| {
            let size_N = 30e3 * ((t.min(25.0) - 25.0) / 5.0).exp();
            HOOK_LOAD_N + size_N * (TAU * t / period_s).sin()
        };
        let settled = ends(growing, 0.0, 20.0).expect("it ends");
        assert!(
            settled.steady && (26.0..31.1).contains(&settled.settle_s),
            "{period_s}: {settled:?}"
        );
    }
}

/// Settling that never becomes steady ends at the bound, and reports it.
#[test]
fn the_bound_ends_what_never_is_steady() {
    let settled = ends(|t| HOOK_LOAD_N + 200.0 * t, 0.0, 5.0).expect("it ends");
    assert!(!settled.steady && (settled.settle_s - 120.01).abs() < 1e-9, "{settled:?}");
}

/// A string that trips at 0.3 m/s changes its hook load with its travel, 150 N/s, and in addition
/// by the fraction of its length that it travels, 1.5 m of 3000 m in a stretch of 5 s or 30 N/s,
/// plus the tenth of a percent, another 60 N/s, of a window as long: 80 N/s more or less than
/// predicted is steady, and is not at the bound. 100 N/s more or less is not, nor is a hook load
/// that is constant while it should change.
#[test]
fn a_string_that_travels_may_change() {
    let rates = [(-230.0, true), (-70.0, true), (-250.0, false), (-50.0, false), (0.0, false)];
    for (rate_N_per_s, steady) in rates {
        for down in [1.0, -1.0] {
            let settled = ends(|t| HOOK_LOAD_N + down * rate_N_per_s * (t - 60.0), down * 0.3, 5.0);
            assert_eq!(settled.expect("it ends").steady, steady, "{rate_N_per_s} {down}");
        }
        let stays = ends(|t| HOOK_LOAD_N + rate_N_per_s * (t - 60.0), 0.0, 5.0);
        assert_eq!(stays.expect("it ends").steady, rate_N_per_s.abs() < 60.0, "{rate_N_per_s}");
    }
}

/// Changes below the resolution of a rig's gauges are no drift: torques of a few N·m in a string
/// that does not turn.
#[test]
fn small_scalars_have_a_least_scale() {
    let [force, torque, own, same] = scales([
        (DriftScale::Force, -3e3),
        (DriftScale::Torque, 20.0),
        (DriftScale::Own(0.1), 0.01),
        (DriftScale::Force, 2e3),
    ]);
    assert_eq!([force, torque, own, same], [1e4, 1e3, 0.1, 1e4]);
    let large =
        scales([(DriftScale::Force, -3e5), (DriftScale::Force, 1.0), (DriftScale::Own(0.1), -4.0)]);
    assert_eq!(large, [3e5, 3e5, 4.0]);
}

#[test]
fn a_fixed_time_ends_by_no_test() {
    let fixed = Settling::Fixed(3.0);
    assert_eq!([fixed.min_s(), fixed.max_s()], [3.0; 2]);
    assert_eq!(fixed.ends(&TimeSeries::default(), INTERVAL_S, 5.0, LENGTH_M), None);
}
