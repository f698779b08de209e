//! Elements of automatic length: where shorter ones are required, and where not.

use std::f64::consts::PI;

use wholestring::{
    dynamics::{Accuracy, Effort, HoistControl, HoistSetPoint, ScheduleStep},
    operation::OperationKind,
    rod::buckled_element::own_load_N,
    sizing::{SizeReason, SizedInterval, Sizing},
    string::{
        BodyBend, Cavity,
        ComponentLength::{Metres, ToSurface},
        ComponentSpec, Eccentricity,
    },
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
    Sizing::auto(&case.model, &[case.operation], accuracy).expect("a valid case")
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

/// Where nothing has joints, because pipe and joints were averaged, the long and light part is the
/// pipe, and the part below it is the assembly.
#[test]
fn a_string_without_joints_has_an_assembly() {
    let plain = [
        tool("bit", Metres(0.3), 0.2159, 0.06),
        tool("drill collar", Metres(100.0), 0.165, 0.0714),
        tool("heavy-weight drill pipe", Metres(50.0), 0.1397, 0.0921),
        tool("drill pipe", ToSurface, 0.1397, 0.1214),
    ];
    let case_of = |components: &[_]| {
        let stations = [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0]];
        let hole = vec![HoleSection::open(0.0..1010.0, 0.2159, 0.3)];
        let path = path(&stations, Interpolation::Spline);
        let model = model(path, hole, components.to_vec(), 1000.0);
        Case::new(model, operation(OperationKind::RotateOffBottom, 1000.0))
    };
    let standard = sizing(&case_of(&plain), Accuracy::Standard);
    assert_eq!(reasons(&standard), [SizeReason::PlainPipe, SizeReason::Assembly]);
    let pipe = standard.intervals().iter().find(|one| one.reason == SizeReason::PlainPipe);
    assert!((pipe.expect("pipe").from_bit_m - 150.3).abs() < 1e-9);
    let alike = sizing(&case_of(&plain[3..]), Accuracy::Standard);
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

/// In compression beyond half of Dawson and Paslay's load of a level hole, `2 √(EI w/r)`, every
/// half wave `π √(2 EI/F)` has four elements at least; far below that load the pipe is meshed from
/// joint to joint.
#[test]
fn compression_near_buckling_is_resolved() {
    let pipe = pushed(0.0).model.string.components()[0].clone();
    let ei = pipe.bending_stiffness_N_m2();
    let clearance_m = 0.5 * 0.2159 - pipe.contact_radius_m();
    let weight = pipe.buoyed_weight_per_length_N_per_m(pushed(0.0).model.mud.density_kg_per_m3);
    let critical_N = 2.0 * (ei * weight / clearance_m).sqrt();
    let below = sizing(&pushed(0.2 * critical_N), Accuracy::Standard);
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
/// the bent part is divided more finely, the straight hole above and below is not.
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

/// Where a build holds a pushed pipe, its critical load is higher than that of a level hole; but
/// between its nodes an element has `π² EI/h²` alone. From half of that on it is cut, so that it is
/// stable under twice its compression.
#[test]
fn elements_bear_twice_their_compression_where_the_hole_holds_the_pipe() {
    let stations = [[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [1200.0, 90.0, 0.0], [1230.0, 90.0, 0.0]];
    let pushed = |weight_N: f64| {
        let model = model(
            path(&stations, Interpolation::MinimumCurvature),
            vec![HoleSection::open(0.0..1240.0, 0.2159, 0.0)],
            vec![drill_pipe()],
            1230.0,
        );
        Case::new(model, operation(OperationKind::Slide, 1230.0).weight_on_bit_N(weight_N))
    };
    let pipe = pushed(0.0).model.string.components()[0].clone();
    let spacing_m = pipe.joints.expect("tool joints").spacing_m;
    let own_N = own_load_N(pipe.bending_stiffness_N_m2(), spacing_m);
    // In the build, at 83 deg, where the compression is that of the bit within a per cent.
    let at = |weight_N: f64, accuracy| *sizing(&pushed(weight_N), accuracy).at(100.0);
    assert_eq!(at(0.4 * own_N, Accuracy::Standard).reason, SizeReason::JointToJoint);
    for over in [0.6, 0.8, 1.1] {
        for accuracy in [Accuracy::Coarse, Accuracy::Standard] {
            let one = at(over * own_N, accuracy);
            assert_ne!(one.reason, SizeReason::JointToJoint, "{over} {accuracy:?}");
            let bears_N = own_load_N(pipe.bending_stiffness_N_m2(), one.element_length_m);
            assert!(bears_N >= 1.98 * over * own_N, "{over} {accuracy:?}: {bears_N} N");
        }
    }
}

/// A schedule that brings four times the critical load to a bit that begins with none: the mesh is
/// that of the heavier weight from the beginning.
#[test]
fn the_mesh_serves_the_heaviest_weight_of_the_schedule() {
    let pipe = pushed(0.0).model.string.components()[0].clone();
    let ei = pipe.bending_stiffness_N_m2();
    let longest_m = |case: &Case| {
        let effort = Effort::of(&case.model, &case.operation, &case.settings).expect("sound");
        effort.mesh.elements.iter().map(|one| one.length_m).fold(0.0, f64::max)
    };
    let mut case = pushed(10e3);
    assert!(longest_m(&case) > 9.0);
    let weight_N = 500e3;
    case.settings.schedule.steps.push(ScheduleStep {
        at_s: 5.0,
        ramp_s: 10.0,
        hoist: Some(HoistSetPoint::WeightOnBit(weight_N)),
        ..ScheduleStep::default()
    });
    let half_wave_m = PI * (2.0 * ei / weight_N).sqrt();
    // Elements are a quarter longer than requested at most.
    assert!(longest_m(&case) <= 1.25 * half_wave_m / 4.0, "{}", longest_m(&case));
    assert_eq!(longest_m(&case), longest_m(&pushed(weight_N)));
}

/// A hook that carries nothing leaves all of a vertical string on its bit: the compression there is
/// its buoyed weight, whatever weight the operation names. Under a lift that leaves the
/// operation's own weight the mesh is that of the operation.
#[test]
fn the_mesh_serves_what_a_constant_lift_leaves_on_the_bit() {
    let hung = |lift: Option<f64>| {
        let stations = [[0.0, 0.0, 0.0], [1500.0, 0.0, 0.0]];
        let model = model(
            path(&stations, Interpolation::Spline),
            vec![HoleSection::open(0.0..1510.0, 0.2159, 0.0)],
            vec![drill_pipe()],
            1500.0,
        );
        let drill = operation(OperationKind::Drill, 1500.0).weight_on_bit_N(10e3);
        let mut case = Case::new(model, drill);
        let pipe = &case.model.string.components()[0];
        let density = case.model.mud.density_kg_per_m3;
        let weight_N = 1500.0 * pipe.buoyed_weight_per_length_N_per_m(density);
        let ei = pipe.bending_stiffness_N_m2();
        case.settings.hoist_control =
            lift.map(|part| HoistControl::HookLoad(part * (weight_N - 10e3)));
        let effort = Effort::of(&case.model, &case.operation, &case.settings).expect("sound");
        (weight_N, ei, effort.mesh)
    };
    let (weight_N, ei, mesh) = hung(Some(0.0));
    let lowest = mesh.elements.last().expect("an element");
    assert_eq!(lowest.reason, SizeReason::Compression);
    assert!(lowest.length_m <= 1.25 * PI * (2.0 * ei / weight_N).sqrt() / 4.0);
    assert_eq!(hung(Some(1.0)).2, hung(None).2);
}

/// A string without drill pipe is all assembly: a collar of 12 m between blades has four elements,
/// or its middle could not bow. So is one below long collars, whose walls are thicker than a
/// pipe's; and an eccentric part of the pipe is cut as finely.
#[test]
fn a_string_without_drill_pipe_is_an_assembly() {
    let blade = || tool("stabiliser", Metres(0.6), 0.2127, 0.07);
    let collar = |length| tool("collar", length, 0.1651, 0.0714);
    let case_of = |components: &[ComponentSpec], length_m: f64| {
        let stations = [[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]];
        let hole = vec![HoleSection::open(0.0..length_m + 10.0, 0.2159, 0.3)];
        let model =
            model(path(&stations, Interpolation::Spline), hole, components.to_vec(), length_m);
        Case::new(model, operation(OperationKind::RotateOffBottom, length_m))
    };
    let lower = [tool("bit", Metres(0.3), 0.2159, 0.06), blade(), collar(Metres(12.0)), blade()];
    let with = |upper: ComponentSpec| lower.iter().cloned().chain([upper]).collect::<Vec<_>>();
    for length_m in [40.0, 250.0] {
        let sizing = sizing(&case_of(&with(collar(ToSurface)), length_m), Accuracy::Standard);
        assert_eq!(reasons(&sizing), [SizeReason::Assembly], "{length_m}");
        assert!(sizing.at(6.0).element_length_m <= 3.0);
    }
    // Pipe of 140 mm over 100 m ends it.
    let pipe = tool("drill pipe", ToSurface, 0.1397, 0.1214);
    let piped = sizing(&case_of(&with(pipe.clone()), 113.5), Accuracy::Standard);
    assert_eq!(reasons(&piped), [SizeReason::PlainPipe, SizeReason::Assembly]);
    assert!((piped.intervals()[1].from_bit_m - 13.5).abs() < 1e-9);
    let eccentricity = Eccentricity { offset_m: 2e-3, phase_rad: 0.0, cavity: Cavity::Sealed };
    let heavy_side = ComponentSpec {
        eccentricity: Some(eccentricity),
        ..tool("worn pipe", Metres(12.0), 0.1397, 0.1214)
    };
    let below = tool("drill pipe", Metres(100.0), 0.1397, 0.1214);
    let worn = sizing(&case_of(&[below, heavy_side, pipe], 200.0), Accuracy::Standard);
    assert!(worn.intervals().iter().any(|one| one.element_length_m <= 3.0));
}

/// A bend that turns with its string has elements of 1.5 m about it, down to the bit; one that
/// slides has those of the assembly.
#[test]
fn a_bend_that_turns_is_resolved() {
    let motor = ComponentSpec {
        bend: Some(BodyBend { angle_rad: 0.026, from_lower_end_m: 2.0, toolface_rad: 0.0 }),
        ..tool("motor", Metres(8.0), 0.1715, 0.127)
    };
    let components = [tool("bit", Metres(0.3), 0.2159, 0.06), motor, drill_pipe()];
    let reason = |kind: OperationKind, accuracy: Accuracy, from_bit_m: f64| {
        let stations = [[0.0, 0.0, 0.0], [500.0, 0.0, 0.0]];
        let hole = vec![HoleSection::open(0.0..510.0, 0.2159, 0.3)];
        let path = path(&stations, Interpolation::Spline);
        let case = Case::new(model(path, hole, components.to_vec(), 500.0), operation(kind, 500.0));
        let one = *sizing(&case, accuracy).at(from_bit_m);
        (one.reason, one.element_length_m)
    };
    use Accuracy::{Coarse, Fine, Standard};
    for from_bit_m in [0.1, 2.3, 11.0] {
        let turning = |accuracy| reason(OperationKind::RotateOffBottom, accuracy, from_bit_m);
        assert_eq!(turning(Standard), (SizeReason::RotatingBend, 1.5), "{from_bit_m}");
        assert_eq!(turning(Fine), (SizeReason::RotatingBend, 0.75), "{from_bit_m}");
        assert_ne!(turning(Coarse).0, SizeReason::RotatingBend, "{from_bit_m}");
        let sliding = reason(OperationKind::Slide, Standard, from_bit_m);
        assert_ne!(sliding.0, SizeReason::RotatingBend, "{from_bit_m}");
    }
    assert_eq!(reason(OperationKind::Drill, Standard, 11.6).0, SizeReason::JointToJoint);
}
