//! Operations that a front end performs on a run in progress.

use super::*;
use crate::dynamics::{settings::SpeedController, simulation::settling::Settling};

const STIFF: SpeedController =
    SpeedController::Pi { proportional_N_m_s: 38e3, integral_N_m: 100e3 };

fn driven(controller: SpeedController) -> DynamicsSettings {
    let top_drive =
        TopDriveSettings::Driven { inertia_kg_m2: 2900.0, controller, torque_limit_N_m: None };
    DynamicsSettings { top_drive, settle_s: 3.0, ..DynamicsSettings::default() }
}

/// A restart of the window does not affect the motion, to the last bit; the earlier samples are
/// gone, and the results are those of the samples since.
#[test]
fn a_window_that_begins_anew_forgets_and_moves_nothing() {
    for settings in [
        DynamicsSettings { settle_s: 3.0, ..DynamicsSettings::default() },
        DynamicsSettings { steady: Some(Default::default()), ..DynamicsSettings::default() },
    ] {
        let mut plain = new_run(&model(0.25), &REAM, &settings);
        let mut anew = plain.clone();
        for run in [&mut plain, &mut anew] {
            run.advance(1.0).unwrap();
        }
        anew.restart_window();
        assert!(anew.series().time_s.is_empty() && !anew.is_settling());
        assert!(anew.outcome().contact.time_s.is_empty());
        for run in [&mut plain, &mut anew] {
            run.advance(0.5).unwrap();
        }
        let rows = anew.series().time_s.len();
        let from = plain.series().time_s.len() - rows;
        assert_eq!(plain.series().time_s[from..], anew.series().time_s);
        assert_eq!(plain.series().hook_load_N[from..], anew.series().hook_load_N);
        // Moments between the ends of elements are updated anew; the motion is the same.
        let motion = |run: &Run<f64>| {
            let frame = run.frame();
            let forces = [frame.tension_N, frame.torque_N_m, frame.contact_force_N];
            (frame.offset_high_m, frame.velocity_right_m_per_s, frame.twist_rad, forces)
        };
        assert_eq!(motion(&plain), motion(&anew));
        let answer = anew.outcome();
        let mean = anew.series().hook_load_N.iter().sum::<f64>() / rows as f64;
        // Sums of some fifty numbers in another order.
        assert!((answer.scalars.hook_load_N / mean - 1.0).abs() < 1e-12);
        assert!((answer.numerics.settle_s - anew.series().time_s[0]).abs() < 1e-9);
        let is_until = matches!(anew.settling, Settling::UntilSteady { .. });
        assert_eq!(answer.numerics.settled, is_until.then_some(false));
        assert_eq!(anew.indicators(), answer.indicators);
        // It is resumed in its present state.
        let bytes = postcard::to_stdvec(&anew.checkpoint()).unwrap();
        let read = postcard::from_bytes(&bytes).unwrap();
        let mut resumed = Run::resume(&anew.model, &REAM, &settings, read).unwrap();
        for run in [&mut anew, &mut resumed] {
            run.advance(0.2).unwrap();
        }
        assert_eq!(anew.frame(), resumed.frame());
    }
}

/// A new controller continues from the present torque. Without it the torque would jump at once by
/// the difference of the gains times the error of the speed: the rotary speed is set 2 rad/s higher
/// just before, 38 kN·m·s less four impedances of 0.37 kN·m·s give 73 kN·m.
#[test]
fn a_controller_goes_on_from_the_torque_of_the_one_before() {
    let soft = SpeedController::SoftTorque { impedance_ratio: 4.0, frequency_Hz: None };
    let z_torque = SpeedController::ZTorque {
        impedance_ratio: 1.0,
        frequency_Hz: None,
        proportional_N_m_s: 38e3,
        integral_N_m: 100e3,
    };
    for (from, to) in [(STIFF, soft), (soft, STIFF), (STIFF, z_torque), (z_torque, STIFF)] {
        let mut run = new_run(&model(0.25), &REAM, &driven(from));
        run.advance(2.0).unwrap();
        let line = ScheduleStep {
            at_s: run.time_s(),
            rotary_speed_rad_per_s: Some(9.0),
            ..ScheduleStep::default()
        };
        run.state.set_points.add(line).unwrap();
        // The set point is there, the drive on its way: something is missing.
        run.step();
        let mut plain = run.clone();
        assert!(run.set_speed_controller(to));
        let before = node!(run.chain, 0, spin);
        for run in [&mut plain, &mut run] {
            run.step();
        }
        let change = |run: &Run<f64>| node!(run.chain, 0, spin) - before;
        let (expected, found) = (change(&plain), change(&run));
        // `J ΔΩ/dt = N + K_i dt e − (K_p + K_i dt) ΔΩ` with `N` the initial excess of the drive's
        // torque over the string's, which is the same for both, and `e` the error of the speed.
        let dt_s = run.time_step_s();
        let missing = 9.0 - before;
        let [old, new] = [from, to]
            .map(|controller| Gains::of(controller, 2900.0, TorsionalString::of(&run.mesh)));
        let inertia = node!(run.chain, 0, polar);
        let gain = |gains: &Gains| gains.integral_N_m.mul_add(dt_s, gains.proportional_N_m_s);
        let push = expected * (inertia / dt_s + gain(&old)) - old.integral_N_m * dt_s * missing;
        let due = (push + new.integral_N_m * dt_s * missing) / (inertia / dt_s + gain(&new));
        // A drive that shows an impedance gives way to the string's torque within the step besides.
        // Had it not begun with the torque that there was, it would be as fast in no time, or turn
        // back: the string's torque over the pipe's impedance is 5 rad/s.
        let has_feedback = old.shown.is_some() || new.shown.is_some();
        let tolerance = if has_feedback { 0.3 } else { 1e-9 };
        assert!((found / due - 1.0).abs() < tolerance, "{from:?} to {to:?}: {found}, due {due}");
        // From then on it is the other's: the same after a checkpoint.
        let bytes = postcard::to_stdvec(&run.checkpoint()).unwrap();
        let read = postcard::from_bytes(&bytes).unwrap();
        let mut resumed = Run::resume(&run.model, &REAM, &driven(from), read).unwrap();
        for run in [&mut plain, &mut run, &mut resumed] {
            run.advance(1.0).unwrap();
        }
        assert_eq!(run.frame(), resumed.frame());
        assert_ne!(run.frame(), plain.frame());
    }
    let mut constant = new_run(&model(0.25), &REAM, &DynamicsSettings::default());
    assert!(!constant.set_speed_controller(STIFF));
}

/// A thousand requests of 3 ms take three seconds, as one does, though samples are 10 ms apart; and
/// a checkpoint contains the remainder of the last one.
#[test]
fn short_requests_add_up() {
    let settings = DynamicsSettings { settle_s: 3.0, ..DynamicsSettings::default() };
    let mut often = new_run(&model(0.25), &REAM, &settings);
    let mut once = often.clone();
    once.advance(3.0).unwrap();
    for _ in 0..500 {
        often.advance(0.003).unwrap();
    }
    assert!((often.time_s() - 1.5).abs() <= 0.5 * often.sample_interval_s());
    let bytes = postcard::to_stdvec(&often.checkpoint()).unwrap();
    let read = postcard::from_bytes(&bytes).unwrap();
    let mut resumed = Run::resume(&often.model, &REAM, &settings, read).unwrap();
    for run in [&mut often, &mut resumed] {
        for _ in 0..500 {
            run.advance(0.003).unwrap();
        }
        assert_eq!(run.time_s(), once.time_s());
        assert_eq!(run.frame(), once.frame());
    }
}

/// Samples are exactly as far apart as the settings require, whether the interval is a few steps,
/// one step or less than the longest stable step. Dropped samples do not affect the motion, only
/// the kept samples use memory, and lines that were added by hand are dropped with their samples.
#[test]
fn dropped_samples_move_nothing() {
    for interval_s in [0.01, 0.013, 2e-4] {
        let settings = DynamicsSettings { sample_interval_s: interval_s, ..driven(STIFF) };
        let mut plain = new_run(&model(0.25), &REAM, &settings);
        let mut drops = plain.clone();
        assert!((plain.sample_interval_s() / interval_s - 1.0).abs() < 1e-12);
        for turn in 0..10 {
            for run in [&mut plain, &mut drops] {
                let line = ScheduleStep {
                    at_s: run.time_s(),
                    rotary_speed_rad_per_s: Some(6.0 + f64::from(turn)),
                    ..ScheduleStep::default()
                };
                run.state.set_points.add(line).unwrap();
                run.advance(10.0 * interval_s).unwrap();
            }
            drops.forget(drops.time_s() - 19.5 * interval_s);
        }
        assert_eq!(plain.frame(), drops.frame());
        let rows = drops.series().time_s.len();
        assert_eq!((plain.series().time_s.len(), rows), (100, 20));
        assert_eq!(plain.series().hook_load_N[80..], drops.series().hook_load_N);
        assert_eq!(drops.series().time_s[0], plain.series().time_s[80]);
        // The first of the two lines is that of the samples from the 81st on.
        assert_eq!(plain.state.set_points.lines().len(), 10);
        assert_eq!(plain.state.set_points.lines()[8..], *drops.state.set_points.lines());
        assert_eq!(drops.series().schedule_line, [[1; 10], [2; 10]].concat());
        let map = drops.outcome().contact;
        assert!(map.time_s.iter().all(|time_s| *time_s >= drops.series().time_s[0]));
        // It is resumed in its present state and continues like the other.
        let bytes = postcard::to_stdvec(&drops.checkpoint()).unwrap();
        let read = postcard::from_bytes(&bytes).unwrap();
        let mut resumed = Run::resume(&drops.model, &REAM, &settings, read).unwrap();
        for run in [&mut plain, &mut drops, &mut resumed] {
            run.advance(5.0 * interval_s).unwrap();
        }
        assert_eq!(plain.frame(), drops.frame());
        assert_eq!(drops.series(), resumed.series());
        drops.forget(f64::INFINITY);
        assert_eq!(drops.series().time_s.len(), 1);
    }
}

/// A string that settles until it is steady does so at the same sample whether the samples that are
/// not needed any more were dropped or not; wear is that of the whole window either way.
#[test]
fn settling_ends_the_same_when_samples_were_dropped() {
    let settings = DynamicsSettings { steady: Some(Default::default()), ..driven(STIFF) };
    let mut plain = new_run(&model(0.25), &REAM, &settings);
    let mut drops = plain.clone();
    // It settles within some ten seconds, and for 120 s at most.
    while plain.is_settling() && plain.time_s() < 200.0 {
        for run in [&mut plain, &mut drops] {
            run.advance(1.0).unwrap();
        }
        drops.forget(f64::INFINITY);
        assert_eq!(plain.state.settled, drops.state.settled);
    }
    assert!(!plain.is_settling(), "the test is of a run that settles");
    for run in [&mut plain, &mut drops] {
        run.advance(1.0).unwrap();
    }
    drops.forget(f64::INFINITY);
    let [plain, drops] = [plain, drops].map(|run| run.outcome().wear.wear_power_W_per_m);
    assert_eq!(plain, drops);
    assert!(plain.iter().any(|power| *power > 0.0));
}
