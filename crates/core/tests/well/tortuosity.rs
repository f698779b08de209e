//! Tortuosity of a planned path: its contribution to the doglegs, and theirs to pull and torque.

use std::f64::consts::TAU;

use crate::common::*;
use wholestring::{
    operation::Operation,
    statics::soft::soft_string,
    well::{Interpolation, Path, Tortuosity, TortuosityKind},
};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn slant(length_m: f64, interpolation: Interpolation) -> Path {
    path(&[[0.0, 60.0, 30.0], [length_m, 60.0, 30.0]], interpolation)
}

fn tortuosity(kind: TortuosityKind, length_m: f64) -> Tortuosity {
    let md_m = [0.0, length_m];
    Tortuosity { kind, amplitude_rad: 0.7 * DEGREE, period_m: 80.0, md_m, seed: 1 }
}

const KINDS: [TortuosityKind; 3] =
    [TortuosityKind::Random, TortuosityKind::Sinusoidal, TortuosityKind::Helical];

/// Of no amplitude it is the plan, bit for bit; the ends are the plan's in any case.
#[test]
fn the_plan_is_kept_without_amplitude_and_at_its_ends() {
    for interpolation in [Interpolation::MinimumCurvature, Interpolation::Spline] {
        let stations =
            [[0.0, 0.0, 0.0], [500.0, 0.0, 45.0], [1500.0, 70.0, 45.0], [3000.0, 70.0, 60.0]];
        let plan = path(&stations, interpolation);
        for kind in KINDS {
            let zero = Tortuosity { amplitude_rad: 0.0, ..tortuosity(kind, 3000.0) };
            let same = plan.with_tortuosity(&zero).expect("a path");
            assert_eq!(same.stations(), plan.stations());
            for md_m in [0.0, 333.3, 777.7, 2999.0, 3100.0] {
                assert_eq!(same.at(md_m), plan.at(md_m));
            }
            let wound = plan.with_tortuosity(&tortuosity(kind, 3000.0)).expect("a path");
            assert!(wound.stations().len() > 30);
            assert_eq!(wound.stations().first(), plan.stations().first());
            assert_eq!(wound.stations().last(), plan.stations().last());
            assert!(wound.turn_rad() > plan.turn_rad() + 0.03);
            // Between its depths alone.
            let part = Tortuosity { md_m: [1000.0, 1400.0], ..tortuosity(kind, 3000.0) };
            let part = plan.with_tortuosity(&part).expect("a path");
            let middle = |md_m: &f64| (1000.0..1400.0).contains(md_m);
            for md_m in
                part.stations().iter().map(|station| station.md_m).filter(|md_m| !middle(md_m))
            {
                let angle = part.at(md_m).dogleg_rad(&plan.at(md_m));
                assert!(angle < 1e-12, "{kind:?} at {md_m} m: {angle}");
            }
        }
    }
}

/// Stations that a longer path adds, in whole periods, have the doglegs of so many waves: of the
/// sine four times its largest angle each, of the helix sixteen chords of a cone.
#[test]
fn doglegs_of_waves_are_those_of_their_closed_forms() {
    let added = |kind| {
        let turn = |length_m: f64| {
            let plan = slant(length_m, Interpolation::MinimumCurvature);
            plan.with_tortuosity(&tortuosity(kind, length_m)).expect("a path").turn_rad()
        };
        (turn(4000.0) - turn(2000.0)) / 25.0
    };
    let angle_rad = 0.7 * DEGREE;
    verify("tortuosity", "doglegs of a wave of the sine, rad")
        .relative(1e-9, "rounding")
        .report(4.0 * 1.25_f64.sqrt() * angle_rad, added(TortuosityKind::Sinusoidal));
    let helix_rad = added(TortuosityKind::Helical);
    let step = TAU / Tortuosity::STATIONS;
    let cosine = angle_rad.cos().powi(2) + angle_rad.sin().powi(2) * step.cos();
    verify("tortuosity", "doglegs of a turn of the helix, rad")
        .relative(1e-6, "the rounding of an angle from its cosine")
        .report(Tortuosity::STATIONS * cosine.acos(), helix_rad);
    verify("tortuosity", "the same, of a helix without end of stations, rad")
        .relative(7e-3, "sixteen chords: a 24th of the square of their angle, 6.4e-3")
        .report(TAU * angle_rad.sin(), helix_rad);
}

/// Random angles are even within the amplitude, and half of them are across the hole; another seed
/// is another path.
#[test]
fn random_angles_are_as_they_are_said_to_be() {
    let length_m = 80_000.0;
    let plan = slant(length_m, Interpolation::MinimumCurvature);
    let tortuosity = tortuosity(TortuosityKind::Random, length_m);
    let wound = plan.with_tortuosity(&tortuosity).expect("a path");
    assert_eq!(wound.stations().len(), 1001);
    let mut squares = 0.0;
    for station in &wound.stations()[1..1000] {
        let built = station.inclination_rad - 60.0 * DEGREE;
        let across = (station.azimuth_rad - 30.0 * DEGREE) * station.inclination_rad.sin();
        assert!(built.abs() <= tortuosity.amplitude_rad * 1.001);
        // To the right as one looks down the hole the azimuth grows.
        assert!((across - 0.5 * built).abs() < 1e-2 * tortuosity.amplitude_rad, "{across} {built}");
        squares += built * built;
    }
    verify("tortuosity", "root mean square of random inclinations, rad")
        .relative(0.04, "999 draws: 1.5 %")
        .report(tortuosity.amplitude_rad / 3.0_f64.sqrt(), (squares / 999.0).sqrt());
    let again = plan.with_tortuosity(&tortuosity).expect("a path");
    assert_eq!(again.stations(), wound.stations());
    let other = plan.with_tortuosity(&Tortuosity { seed: 2, ..tortuosity }).expect("a path");
    assert_ne!(other.stations(), wound.stations());
}

/// A string without weight that is pulled through the waves: Euler's capstan on each of them, and
/// the torque of the same side force where it turns. On arcs the doglegs are the path's turn; on
/// the curve with continuous curvature it overshoots them a little.
#[test]
fn pull_and_torque_are_those_of_a_capstan() {
    let (mu, radius_m, pull_N) = (0.3, 0.07, 400e3);
    for (kind, wave_rad, tolerance, reason) in [
        (TortuosityKind::Sinusoidal, 4.0 * 1.25_f64.sqrt() * 0.7 * DEGREE, 2e-6, "its weight"),
        (TortuosityKind::Helical, TAU * (0.7 * DEGREE).sin(), 7e-3, "sixteen chords a turn"),
    ] {
        for (interpolation, more, named) in [
            (Interpolation::MinimumCurvature, 0.0, "arcs"),
            (Interpolation::Spline, 0.02, "the curve with continuous curvature"),
        ] {
            let solved = |length_m: f64, operation_at: fn(f64) -> Operation| {
                let stations = [[0.0, 60.0, 30.0], [length_m, 60.0, 30.0]];
                let mut model = uniform_model(&stations, 1e-6, radius_m, mu);
                let plan = slant(length_m, interpolation);
                model.well.path = plan.with_tortuosity(&tortuosity(kind, length_m)).expect("one");
                let operation =
                    operation_at(length_m).bit_pull_N(pull_N).rotary_speed_rad_per_s(10.0);
                soft_string(&model, &operation).expect("an answer").scalars
            };
            let hook = |length_m| solved(length_m, Operation::trip_out).hook_load_N.ln();
            let grows = (hook(4000.0) - hook(2000.0)) / 25.0;
            verify("tortuosity", format!("logarithm of the pull by a wave: {kind:?} on {named}"))
                .relative(tolerance + more, reason)
                .report(mu * wave_rad, grows);
            let torque =
                |length_m| solved(length_m, Operation::rotate_off_bottom).surface_torque_N_m;
            let turns = (torque(4000.0) - torque(2000.0)) / 25.0;
            verify("tortuosity", format!("torque of a wave of {kind:?} on {named}, N·m"))
                .relative(tolerance + more, reason)
                .report(mu * radius_m * pull_N * wave_rad, turns);
        }
    }
}
