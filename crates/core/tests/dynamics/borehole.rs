//! Influences on which a run must not depend: settling, elements, the beginning of the survey, the
//! form of the hoist's request.

use wholestring::{
    dynamics::HoistControl,
    dynamics::MeshSettings,
    prelude::*,
    well::{Interpolation, TieIn},
};

use crate::{
    common::{assert_close, operation, path},
    wells::{Case, STRAIGHT_DEG, each, go, mean_between, model, moderate, straight, tool},
};

/// A block velocity that is requested as a setting is the string's speed: reaming 500 m at 0.5 m/s
/// drags and rubs and pulls alike, whatever speed the operation names.
///
/// The two runs are the same problem but for the twist of their starts, which the named speed has a
/// part in; 1e-5 of it is left after five seconds.
#[test]
fn a_block_velocity_is_the_trip_speed() {
    let found = each(&[None, Some(0.2)], |named| {
        let mut operation = operation(OperationKind::Ream, 500.0);
        operation.trip_speed_m_per_s = named.unwrap_or(0.5);
        let mut case = Case::new(straight(500.0, 0.25), operation);
        case.settings.hoist_control = named.map(|_| HoistControl::BlockVelocity(0.5));
        case.lasts(5.0, 5.0);
        case.run().scalars
    });
    let pair = |scalars: fn(&wholestring::outcome::Scalars) -> f64| {
        [scalars(&found[1]), scalars(&found[0])]
    };
    for (what, [set, named]) in [
        ("hook load", pair(|s| s.hook_load_N)),
        ("axial friction", pair(|s| s.axial_friction_N)),
        ("torque", pair(|s| s.friction_torque_N_m)),
    ] {
        assert_close(what, set, named, 1e-5);
    }
}

/// Tripping out with the block velocity of a setting has the hook load of the same trip speed.
#[test]
fn a_trip_by_block_velocity_has_its_hook_load() {
    let found = each(&[None, Some(0.2)], |named| {
        let mut case = moderate(OperationKind::TripOut, 0.25);
        case.operation.trip_speed_m_per_s = named.unwrap_or(0.5);
        case.settings.hoist_control = named.map(|_| HoistControl::BlockVelocity(-0.5));
        case.lasts(3.0, 3.0);
        case.run().scalars.hook_load_N
    });
    // At the start the friction around differs by the named speed; it has settled to 1e-4 after 3
    // s.
    assert_close("hook load", found[1], found[0], 1e-4);
}

/// A prepared start is the operation itself: a window from time zero has the means of one that
/// settled first, and its first row is like every other.
///
/// Within 1 % of the hook load, and 3 % of side force, axial friction and torque, which the first
/// seconds' rolling up the wall takes part in.
#[test]
fn a_run_without_settling_is_like_a_settled_one() {
    for kind in [OperationKind::TripOut, OperationKind::RotateOffBottom] {
        let outcomes = each(&[0.0, 10.0], |settle_s| {
            let mut case = moderate(kind, 0.25);
            case.settings.settle_s = *settle_s;
            case.run()
        });
        let [fresh, settled] = [0, 1].map(|i: usize| outcomes[i].scalars);
        let close = |what: &str, found: f64, expected: f64, tolerance| {
            assert_close(&format!("{what} of {}", kind.name()), found, expected, tolerance);
        };
        close("hook load", fresh.hook_load_N, settled.hook_load_N, 0.01);
        close("side force", fresh.side_force_total_N, settled.side_force_total_N, 0.03);
        if kind.rotates() {
            let torque = [&fresh, &settled].map(|s| s.friction_torque_N_m);
            close("torque", torque[0], torque[1], 0.03);
        } else {
            let friction = [&fresh, &settled].map(|s| s.axial_friction_N);
            close("axial friction", friction[0], friction[1], 0.03);
        }
        let series = &outcomes[0].series;
        for (what, values) in [
            ("hook load", &series.hook_load_N),
            ("side force", &series.side_force_total_N),
            if kind.rotates() {
                ("friction torque", &series.friction_torque_N_m)
            } else {
                ("axial friction", &series.axial_friction_N)
            },
        ] {
            let ratio = values[0] / values[9];
            assert!(
                (0.5..2.0).contains(&ratio),
                "{what} of {}: {} first, {} then",
                kind.name(),
                values[0],
                values[9]
            );
        }
    }
}

/// A hole that builds from the surface: the top of the string, on its axis, slides ten metres into
/// the build. Its hook load is the soft string's, within 1 %, though samples are half a metre
/// apart, and its top stays on the axis to a hundredth of a millimetre: the wall is known to the
/// third order of the distance between anchors, centimetres here.
///
/// Friction is a fifth of the hook load here, and 4 % of it is missing: the part of the clamped top
/// and the bit, 12 m of 600 at either end.
#[test]
fn a_build_from_the_surface_keeps_its_hook_load() {
    let mut stations: Vec<[f64; 3]> =
        (0..=10).map(|i| [30.0 * f64::from(i), 4.5 * f64::from(i), 40.0]).collect();
    stations.push([600.0, 45.0, 40.0]);
    let model = model(
        path(&stations, Interpolation::Spline),
        vec![HoleSection::open(0.0..620.0, 0.2159, 0.25)],
        vec![tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186)],
        600.0,
    );
    for kind in [OperationKind::TripIn, OperationKind::TripOut] {
        let mut operation = operation(kind, 600.0);
        operation.trip_speed_m_per_s = 0.5;
        let mut case = Case::new(model.clone(), operation);
        case.settings.sample_interval_s = 1.0;
        let (outcome, expected) = (case.run(), case.soft().scalars);
        let found = outcome.scalars;
        let off = outcome.nodes.lateral_offset_m[0];
        assert!(off < 1e-5, "the top is {off} m off the axis");
        assert_close(
            &format!("hook load of {}", kind.name()),
            found.hook_load_N,
            expected.hook_load_N,
            0.01,
        );
    }
}

/// A survey that begins a kilometre down, at the wellhead of that depth or below a tie-in: dynamics
/// and soft string stretch alike, for mud presses on both alike.
///
/// Without friction both are the integral of the same tension: 0.5 % of the stretch for the bending
/// that the dynamic string has.
#[test]
fn a_survey_that_begins_deep_stretches_alike() {
    for tvd_m in [0.0, 1000.0] {
        let mut case =
            Case::new(straight(300.0, 0.0), operation(OperationKind::RotateOffBottom, 300.0));
        let station =
            |md_m| Station { md_m, inclination_rad: STRAIGHT_DEG.to_radians(), azimuth_rad: 0.3 };
        let tie_in = TieIn { tvd_m, ..TieIn::default() };
        case.model.well.path =
            Path::new(&[station(0.0), station(300.0)], Interpolation::Spline, tie_in)
                .expect("a sound survey");
        let (found, expected) = (case.run().scalars.stretch_m, case.soft().scalars.stretch_m);
        assert_close(&format!("stretch from {tvd_m} m"), found, expected, 5e-3);
    }
}

/// A bit of four metres, which fills its hole, has a node inside where elements are short and none
/// where they are long: the torque of the string above does not know, within 1 %.
#[test]
fn a_long_bit_has_the_torque_of_any_mesh() {
    let torques = each(&[3.2, 1.6], |element_length_m| {
        let mut case =
            Case::new(straight(300.0, 0.25), operation(OperationKind::RotateOffBottom, 300.0));
        case.model.string = StringSpec {
            components: vec![
                tool("bit", ComponentLength::Metres(4.0), 0.2159, 0.0714),
                tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186),
            ],
        }
        .assemble(300.0)
        .expect("a sound string");
        case.settings.mesh = MeshSettings::uniform(*element_length_m);
        case.run().scalars.friction_torque_N_m
    });
    assert_close("torque", torques[0], torques[1], 0.01);
}

/// A motor of 9 m that almost fills its hole is on the wall, whether or not a bit is listed below
/// it: no node of it leaves the hole by more than the contact's deformation, and the deepest
/// penetration agrees with the nodes' offsets.
///
/// Its clearance is 1.95 mm; without a wall a node of it was 36 mm off the axis.
#[test]
fn a_snug_motor_touches_the_wall() {
    let motor = tool("motor", ComponentLength::Metres(9.0), 0.212, 0.0714);
    let pipe = tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186);
    let bit = tool("bit", ComponentLength::Metres(0.3), 0.2159, 0.0714);
    let strings = [vec![motor.clone(), pipe.clone()], vec![bit, motor, pipe]];
    for outcome in each(&strings, |components| {
        let mut case = Case::new(straight(300.0, 0.25), operation(OperationKind::TripIn, 300.0));
        case.model.string =
            StringSpec { components: components.clone() }.assemble(300.0).expect("a sound string");
        case.run()
    }) {
        let (nodes, deepest_m) = (&outcome.nodes, outcome.numerics.max_penetration_m);
        let bit_m = nodes.md_m[nodes.md_m.len() - 1];
        let motor = |md: f64| (0.4..9.0).contains(&(bit_m - md));
        let mut touching = 0;
        for (i, md) in nodes.md_m.iter().enumerate().filter(|(_, md)| motor(**md)) {
            let past_m = nodes.lateral_offset_m[i] - 0.5 * (0.2159 - 0.212);
            assert!(past_m < 5e-4, "{past_m} m in the wall at {md} m");
            assert!(deepest_m >= past_m, "{deepest_m} {past_m}");
            touching += usize::from(nodes.contact_fraction[i] > 0.99);
        }
        assert!(touching > 0, "nothing of the motor touches");
        let contact = outcome.numerics.deepest_contact.expect("it touches");
        assert!(contact.penetration_m > 0.0 && contact.penetration_m <= deepest_m, "{contact:?}");
        assert!(deepest_m < 1e-3, "{deepest_m}");
    }
}

/// A bit that its spring allows off the axis is in the wall by the geometric penetration, though no
/// wall acts on it: it fills its hole, so by all of its offset.
#[test]
fn a_held_bit_shows_its_penetration() {
    let mut case = Case::new(straight(300.0, 0.25), operation(OperationKind::TripIn, 300.0));
    let components = vec![
        tool("bit", ComponentLength::Metres(0.3), 0.2159, 0.0714),
        tool("collar", ComponentLength::Metres(60.0), 0.165, 0.0714),
        tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186),
    ];
    case.model.string = StringSpec { components }.assemble(300.0).expect("a sound string");
    case.settings.bit.lateral_stiffness_N_per_m = 1e6;
    let outcome = case.run();
    let offset_m = *outcome.nodes.lateral_offset_m.last().expect("a bit");
    assert!(offset_m > 2e-3, "the bit hangs {offset_m} m off the axis");
    let deepest_m = outcome.numerics.max_penetration_m;
    // The largest of the samples is not below their mean.
    assert!(deepest_m >= offset_m, "{deepest_m} {offset_m}");
    assert!(deepest_m < 2.0 * offset_m, "{deepest_m} {offset_m}");
    // The wall does not yield: the nodes that touch it penetrate far less.
    let contact = outcome.numerics.deepest_contact.expect("the collar lies on the wall");
    assert!(contact.penetration_m < 0.1 * offset_m, "{contact:?} {offset_m}");
    let bit_m = *outcome.nodes.md_m.last().expect("a bit");
    assert!((0.0..bit_m + 10.0).contains(&contact.md_m), "{contact:?}");
}

/// Elements of half a metre take six times as many steps a second: ten seconds after its start a
/// drilling string has its weight on bit within 3 % all the same.
///
/// Every operation is tested to 3 % at the usual length.
#[test]
fn short_elements_hold_their_weight_on_bit() {
    let drill = operation(OperationKind::Drill, 400.0)
        .weight_on_bit_N(20e3)
        .bit_torque_N_m(1000.0)
        .rate_of_penetration_m_per_s(10.0 / 3600.0);
    let mut case = Case::new(straight(400.0, 0.25), drill);
    case.settings.mesh = MeshSettings::uniform(0.5);
    case.lasts(0.0, 12.0);
    let mut simulation = case.start();
    go(&mut simulation, 11.0);
    let series = simulation.outcome().series;
    let found = mean_between(&series.time_s, &series.weight_on_bit_N, 9.0, 11.0);
    assert_close("weight on bit", found, 20e3, 0.03);
}
