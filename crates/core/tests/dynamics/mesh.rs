//! Elements that choose their length: where something asks for shorter ones, and where nothing
//! does.

use std::f64::consts::PI;

use wholestring::{
    dynamics::Accuracy,
    operation::OperationKind,
    sizing::{SizeReason, SizedInterval, Sizing},
    string::ComponentLength::{Metres, ToSurface},
    well::{HoleSection, Interpolation},
};

use crate::{
    common::{
        np13::{drill_pipe, tool},
        operation, path,
    },
    wells::{Case, model, np13},
};

fn sizing(case: &Case, accuracy: Accuracy) -> Sizing {
    Sizing::auto(&case.model, &[case.operation], accuracy).expect("a sound case")
}

fn reasons(sizing: &Sizing) -> Vec<SizeReason> {
    let mut reasons: Vec<_> = sizing.intervals().iter().map(|one| one.reason).collect();
    reasons.sort();
    reasons.dedup();
    reasons
}

/// Nothing of the article's string touches between its joints or is near buckling: it goes from
/// joint to joint, its assembly too where the answer may be coarse.
#[test]
fn pipe_that_lies_on_its_joints_goes_from_joint_to_joint() {
    let case = np13(0.3);
    use SizeReason::{Assembly, JointToJoint, PlainPipe};
    assert_eq!(reasons(&sizing(&case, Accuracy::Coarse)), [JointToJoint, PlainPipe]);
    let standard = sizing(&case, Accuracy::Standard);
    assert_eq!(reasons(&standard), [JointToJoint, Assembly]);
    // 30.79 m of tools, two stretches of heavy-weight pipe of 84.53 m and the jar between them.
    let top_m = 30.79 + 2.0 * 84.53 + 3.57;
    let pipe = standard.intervals().iter().find(|one| one.reason == JointToJoint);
    assert!((pipe.expect("pipe").from_bit_m - top_m).abs() < 1e-9);
    let fine = sizing(&case, Accuracy::Fine);
    for (one, half) in standard.intervals().iter().zip(fine.intervals()) {
        assert_eq!(half, &SizedInterval { element_length_m: 0.5 * one.element_length_m, ..*one });
    }
}

/// Where nothing has joints, for pipe and joints were averaged, the pipe is what is long and light,
/// and what lies below it is the assembly.
#[test]
fn a_string_without_joints_has_an_assembly() {
    let plain = [
        tool("bit", Metres(0.3), 0.2159, 0.06),
        tool("drill collar", Metres(100.0), 0.165, 0.0714),
        tool("heavy-weight drill pipe", Metres(50.0), 0.1397, 0.0921),
        tool("drill pipe", ToSurface, 0.1397, 0.1214),
    ];
    let of = |components: &[_]| {
        let stations = [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0]];
        let hole = vec![HoleSection::open(0.0..1010.0, 0.2159, 0.3)];
        let path = path(&stations, Interpolation::Spline);
        let model = model(path, hole, components.to_vec(), 1000.0);
        Case::new(model, operation(OperationKind::RotateOffBottom, 1000.0))
    };
    let standard = sizing(&of(&plain), Accuracy::Standard);
    assert_eq!(reasons(&standard), [SizeReason::PlainPipe, SizeReason::Assembly]);
    let pipe = standard.intervals().iter().find(|one| one.reason == SizeReason::PlainPipe);
    assert!((pipe.expect("pipe").from_bit_m - 150.3).abs() < 1e-9);
    let alike = sizing(&of(&plain[3..]), Accuracy::Standard);
    assert_eq!(reasons(&alike), [SizeReason::PlainPipe]);
}

/// Distances counted in elements and back, across the places where the length changes.
#[test]
fn lengths_and_places_are_each_others_inverse() {
    let sizing = sizing(&np13(0.3), Accuracy::Standard);
    for low_m in [0.0, 12.3, 200.0, 203.42, 1000.0] {
        for high_m in [low_m, low_m + 0.5, low_m + 7.0, low_m + 333.3] {
            let lengths = sizing.lengths_between(low_m, high_m);
            let back_m = sizing.place_above(low_m, lengths);
            assert!((back_m - high_m).abs() < 1e-9, "{low_m} {high_m}: {back_m}");
        }
    }
}

/// A level string, pushed: drill pipe of 5-1/2 in over 1000 m, `weight_N` on its bit, without
/// friction.
fn pushed(weight_N: f64) -> Case {
    let stations = [[0.0, 90.0, 0.0], [1000.0, 90.0, 0.0]];
    let model = model(
        path(&stations, Interpolation::Spline),
        vec![HoleSection::open(0.0..1010.0, 0.2159, 0.0)],
        vec![drill_pipe()],
        1000.0,
    );
    Case::new(model, operation(OperationKind::Slide, 1000.0).weight_on_bit_N(weight_N))
}

/// Where compression is beyond half of Dawson and Paslay's load of a level hole, `2 √(EI w/r)`,
/// every half wave `π √(2 EI/F)` has four elements at least; below that load the pipe goes from
/// joint to joint.
#[test]
fn compression_near_buckling_is_resolved() {
    let pipe = pushed(0.0).model.string.components()[0].clone();
    let ei = pipe.bending_stiffness_N_m2();
    let clearance_m = 0.5 * 0.2159 - pipe.contact_radius_m();
    let weight = pipe.buoyed_weight_per_length_N_per_m(pushed(0.0).model.mud.density_kg_per_m3);
    let critical_N = 2.0 * (ei * weight / clearance_m).sqrt();
    let below = sizing(&pushed(0.4 * critical_N), Accuracy::Standard);
    assert_eq!(reasons(&below), [SizeReason::JointToJoint]);
    for over in [0.6, 0.9, 1.0, 2.0, 4.0] {
        let compression_N = over * critical_N;
        let sizing = sizing(&pushed(compression_N), Accuracy::Standard);
        assert_eq!(reasons(&sizing), [SizeReason::Compression], "{over}");
        let half_wave_m = PI * (2.0 * ei / compression_N).sqrt();
        let element_m = sizing.at(500.0).element_length_m;
        assert!(element_m <= half_wave_m / 4.0, "{over}: {element_m} of {half_wave_m}");
        assert!(element_m > half_wave_m / 6.0, "{over}: {element_m} of {half_wave_m}");
    }
}

/// In a build of 10°/30 m with 600 kN below it the body is pulled onto the wall between its joints:
/// what bends is cut finer, the straight hole above and below is not.
#[test]
fn a_body_that_touches_in_a_dogleg_is_resolved() {
    let mut stations = vec![[0.0, 0.0, 0.0]];
    stations.extend((0..=6).map(|i| [600.0 + 30.0 * f64::from(i), 10.0 * f64::from(i), 0.0]));
    stations.push([3000.0, 60.0, 0.0]);
    let model = model(
        path(&stations, Interpolation::MinimumCurvature),
        vec![HoleSection::open(0.0..3010.0, 0.2159, 0.5)],
        vec![drill_pipe()],
        3000.0,
    );
    let case = Case::new(model, operation(OperationKind::TripOut, 3000.0));
    let sizing = sizing(&case, Accuracy::Standard);
    assert_eq!(reasons(&sizing), [SizeReason::JointToJoint, SizeReason::BodyContact]);
    let at_md = |md_m: f64| sizing.at(3000.0 - md_m).reason;
    for (md_m, reason) in [
        (500.0, SizeReason::JointToJoint),
        (610.0, SizeReason::BodyContact),
        (690.0, SizeReason::BodyContact),
        (770.0, SizeReason::BodyContact),
        (900.0, SizeReason::JointToJoint),
        (2900.0, SizeReason::JointToJoint),
    ] {
        assert_eq!(at_md(md_m), reason, "{md_m}");
    }
}
