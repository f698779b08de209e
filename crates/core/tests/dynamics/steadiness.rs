//! A quiet string settles and stays.

use crate::{
    common::relative_error,
    wells::{mean_between, np13},
};

/// Ten seconds after the prepared start of a quiet run the string has settled: torque and hook load
/// stand still to 0.1 kN·m and 0.1 kN, the weight on bit is within 3 % of its target.
///
/// Expected: nothing varies in a quiet run. The limits are a few thousandths of the torque (37 kN·m), of
/// the hook load (650 kN) and of what the autodriller has to hold.
#[test]
fn a_prepared_start_is_settled_in_ten_seconds() {
    let mut case = np13(0.3);
    case.settings.duration_s = 20.0;
    let outcome = case.run();
    let of = |name: &str| {
        outcome.statistics.iter().find(|(n, _)| *n == name).map(|(_, s)| *s).expect("a statistic")
    };
    let (torque, hook) = (of("surface_torque_N_m"), of("hook_load_N"));
    let weight = of("weight_on_bit_N");
    eprintln!("settled: torque std {} hook std {} wob {} of {} ({}..{})", torque.std, hook.std, weight.mean, case.operation.weight_on_bit_N, weight.min, weight.max);
    assert!(torque.std < 100.0, "torque varies by {} N·m", torque.std);
    assert!(hook.std < 100.0, "hook load varies by {} N", hook.std);
    for (what, found) in [("least", weight.min), ("mean", weight.mean), ("most", weight.max)] {
        let off = relative_error(found, case.operation.weight_on_bit_N);
        assert!(off < 0.03, "{what} weight on bit is {found} N, off by {off:.3}");
    }
}

/// Over 600 s of quiet rotation the torque drifts by less than 0.2 %: the means over windows of 30 s
/// all lie within that of the first.
///
/// Expected: no drift, for the well below stays the same (1.7 m are drilled, a part in 2500 of the
/// string, which adds 0.04 % of torque at most).
#[test]
fn ten_minutes_of_quiet_rotation_do_not_drift() {
    let mut case = np13(0.3);
    case.settings.element_length_m = 4.8;
    case.settings.duration_s = 600.0;
    case.settings.sample_interval_s = 0.05;
    let outcome = case.run();
    let series = &outcome.series;
    let mean = |from: f64| mean_between(&series.time_s, &series.surface_torque_N_m, from, from + 30.0);
    let first = mean(10.0);
    for window in 1..20 {
        let later = mean(10.0 + 30.0 * f64::from(window));
        let drift = relative_error(later, first);
        eprintln!("drift: window {window} {:.2e}", later / first - 1.0);
        assert!(drift < 2e-3, "torque goes from {first} to {later} N·m");
    }
}
