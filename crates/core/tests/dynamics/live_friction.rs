//! Friction that changes while the run continues.

use wholestring::{
    dynamics::{FrictionFault, Precision},
    outcome::TimeSeries,
    prelude::*,
    well::HoleKind,
};

use crate::{
    common::{assert_close, operation},
    wells::{Case, change_hole, each, go, mean_between, moderate, straight},
};

const LENGTH_M: f64 = 300.0;

/// A pipe that is pulled out of a straight hole without turning.
fn pulled(mu: f64) -> Case {
    let mut trip = operation(OperationKind::TripOut, LENGTH_M);
    trip.trip_speed_m_per_s = 0.2;
    let mut case = Case::new(straight(LENGTH_M, mu), trip);
    // Axial vibration of the pipe decays within a second; a pipe that slides is not held back.
    case.settings.damping.mass_per_s = 3.0;
    case.lasts(2.0, 10.0);
    case
}

/// Coulomb's friction of a pipe that slides along a straight hole is `μ N`, `N` its weight across
/// the hole; the hook carries it besides the weight along the hole, also while `μ` is on its way.
///
/// Friction over side force is the coefficient to 1e-9 where it rests: sums of the same numbers. On
/// its way it is found every 16 steps, and a sample averages: it is late by no more than both. The
/// hook load, once the waves of the change have died, is that of a run without the change and the
/// difference of both frictions, to 1e-6 of 7 kN: found is 2e-9. The side force changes by 5e-4
/// with the tension, where the pipe leaves the hole's axis at its ends.
#[test]
fn friction_on_its_way_is_coulombs() {
    let mut simulation = pulled(0.2).start();
    go(&mut simulation, 4.0);
    simulation.set_friction(&[0.3], 2.0).expect("sound friction");
    go(&mut simulation, 1.0);
    assert!((simulation.friction()[0] - 0.25).abs() < 1e-3, "{:?}", simulation.friction());
    go(&mut simulation, 7.0);
    assert_eq!(simulation.friction(), [0.3]);
    let late_s = 16.0 * simulation.time_step_s() + simulation.sample_interval_s();
    let series = simulation.series();
    for (row, time_s) in series.time_s.iter().enumerate().skip(100) {
        let mu = 0.2 + 0.1 * ((time_s - 4.0) / 2.0).clamp(0.0, 1.0);
        let found = series.axial_friction_N[row] / series.side_force_total_N[row];
        let moves = *time_s > 4.0 && *time_s < 6.0 + late_s;
        let tolerance = if moves { 0.1 / 2.0 * late_s } else { 1e-9 };
        assert!((found - mu).abs() < tolerance, "{time_s} s: {found} for {mu}");
    }
    let mut same = pulled(0.2).start();
    go(&mut same, 12.0);
    let mean = |series: &TimeSeries, values: fn(&TimeSeries) -> &[f64]| {
        mean_between(&series.time_s, values(series), 11.0, 12.0)
    };
    let [changed_N, same_N] =
        [series, same.series()].map(|series| mean(series, |series| &series.hook_load_N));
    let across =
        [series, same.series()].map(|series| mean(series, |series| &series.side_force_total_N));
    let expected_N = 0.3 * across[0] - 0.2 * across[1];
    assert_close("change of the hook load", changed_N - same_N, expected_N, 1e-6);
    assert_close("side force", across[0], across[1], 1e-3);
}

/// A run whose friction has changed reaches the state of a run with that friction from the start,
/// in a well with a build and a turn, cased and open hole of their own.
///
/// The change rings along the string, and dies with the mass damping of 0.1 1/s. Means over 30 s
/// are held to 2e-4 of the hook load and 4e-4 of the axial friction: found is 8e-5 and 1.3e-4.
#[test]
fn changed_friction_is_that_of_a_hole_that_has_it() {
    let mut changed = moderate(OperationKind::TripOut, 0.2);
    changed.lasts(10.0, 30.0);
    let mut always = changed.clone();
    change_hole(&mut always.model, |section| {
        let kinetic = if section.kind == HoleKind::Casing { 0.25 } else { 0.35 };
        HoleSection { friction: Friction::uniform(kinetic), ..*section }
    });
    let found = each(&[(changed, true), (always, false)], |(case, changes)| {
        let mut simulation = case.start();
        go(&mut simulation, 2.0);
        if *changes {
            simulation.set_friction(&[0.25, 0.35], 1.0).expect("sound friction");
        }
        go(&mut simulation, 38.0);
        simulation.outcome().scalars
    });
    assert_close("hook load", found[0].hook_load_N, found[1].hook_load_N, 2e-4);
    assert_close("axial friction", found[0].axial_friction_N, found[1].axial_friction_N, 4e-4);
}

/// Written to a checkpoint in the middle of a change and after it, a run continues with the same
/// bits, in either precision, and nodes that slide on get the changed friction.
#[test]
fn changed_friction_is_taken_up_where_it_was_left() {
    for precision in [Precision::Double, Precision::Single] {
        let mut case = moderate(OperationKind::Ream, 0.3);
        case.settings.precision = precision;
        let mut whole = case.start();
        go(&mut whole, 0.4);
        whole.set_friction(&[0.2, 0.4], 0.5).expect("sound friction");
        go(&mut whole, 0.25);
        let middle = whole.checkpoint().into_owned();
        go(&mut whole, 0.5);
        let after = whole.checkpoint().into_owned();
        go(&mut whole, 0.5);
        for (checkpoint, seconds) in [(middle, 1.0), (after, 0.5)] {
            let resumed =
                Simulation::resume(&case.model, &case.operation, &case.settings, checkpoint);
            let mut resumed = resumed.expect("the same run");
            go(&mut resumed, seconds);
            assert!(whole.outcome() == resumed.outcome());
            assert_eq!(resumed.friction(), [0.2, 0.4]);
        }
    }
}

/// Friction at rest keeps its ratio to the kinetic one, and an impossible coefficient is rejected.
#[test]
fn friction_that_no_wall_has_is_refused() {
    let hole = straight(LENGTH_M, 0.2).well.hole;
    let sticky = hole.with_friction_of(|_| 0.2).expect("a sound hole");
    assert_eq!(sticky.sections()[0].friction, Friction::uniform(0.2));
    let mut simulation = pulled(0.2).start();
    let two = simulation.set_friction(&[0.1, 0.2], 0.0);
    assert_eq!(two, Err(FrictionFault::Count { given: 2, sections: 1 }));
    let late = simulation.set_friction(&[0.1], f64::NAN);
    assert!(matches!(late, Err(FrictionFault::Ramp(_))), "{late:?}");
    for mu in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = simulation.set_friction(&[mu], 0.0);
        assert!(matches!(refused, Err(FrictionFault::Hole(_))), "{refused:?}");
    }
    assert_eq!(simulation.friction(), [0.2]);
}
