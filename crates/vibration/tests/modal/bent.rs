//! Bent motors: a string that rotates has the torsional modes of a straight one at every tool face.

use std::f64::consts::TAU;

use wholestring::{
    dynamics::{DynamicsSettings, HoistControl},
    prelude::*,
    statics::stiff::StiffSettings,
    string::{BodyBend, ComponentSpec},
};
use wholestring_vibration::modal::{Family, Mode, SmallMotions};

use crate::common::{self, report_worst, rpm, steel, verify};

/// A motor of 8 m with a bend 1.5 m from its lower end, deg, at a tool face, deg.
fn motor([od_m, id_m]: [f64; 2], [bend_deg, toolface_deg]: [f64; 2]) -> ComponentSpec {
    let bend = BodyBend {
        angle_rad: bend_deg.to_radians(),
        from_lower_end_m: 1.5,
        toolface_rad: toolface_deg.to_radians(),
    };
    let body = ComponentSpec::uniform("motor", od_m, id_m, Metres(8.0), steel());
    ComponentSpec { bend: (bend_deg > 0.0).then_some(bend), ..body }
}

fn tool(name: &str, [od_m, id_m]: [f64; 2], length: ComponentLength) -> ComponentSpec {
    ComponentSpec::uniform(name, od_m, id_m, length, steel())
}

/// A slim assembly in a lateral of 3 km.
fn lateral(bend: [f64; 2], friction: f64) -> Model {
    const TOOL: [f64; 2] = [0.12065, 0.05715];
    let stations =
        [[0.0, 0.0, 180.0], [1800.0, 0.0, 180.0], [2100.0, 90.0, 180.0], [5100.0, 90.0, 180.0]];
    let components = vec![
        tool("bit", [0.155575, 0.0], Metres(0.25)),
        motor(TOOL, bend),
        tool("MWD", TOOL, Metres(18.0)),
        tool("drill pipe", [0.1016, 0.084836], ToSurface),
    ];
    let hole = common::open_hole(0.155575, friction, 5100.0);
    common::model(common::arcs(&stations), hole, components, common::mud(1150.0), 5100.0)
}

/// Collars and heavy-weight pipe in a tangent of 40 deg.
fn tangent(bend: [f64; 2], friction: f64) -> Model {
    let stations = [
        [0.0, 0.0, 45.0],
        [600.0, 0.0, 45.0],
        [900.0, 20.0, 45.0],
        [1200.0, 40.0, 45.0],
        [2600.0, 40.0, 45.0],
    ];
    let components = vec![
        tool("bit", [0.2159, 0.0], Metres(0.3)),
        motor([0.17145, 0.1016], bend),
        tool("collars", [0.1651, 0.0714375], Metres(100.0)),
        tool("heavy-weight drill pipe", [0.127, 0.0762], Metres(110.0)),
        tool("drill pipe", [0.127, 0.1086], ToSurface),
    ];
    let hole = common::open_hole(0.2159, friction, 2600.0);
    common::model(common::arcs(&stations), hole, components, common::mud(1250.0), 2600.0)
}

/// The same assembly in a vertical hole, where weight on the bit bows it.
fn vertical(bend: [f64; 2], friction: f64) -> Model {
    let slanted = tangent(bend, friction);
    let path = common::arcs(&[[0.0, 0.0, 0.0], [2600.0, 0.0, 0.0]]);
    Model { well: Well { path, hole: slanted.well.hole.clone() }, ..slanted }
}

fn operation(kind: OperationKind, model: &Model) -> Operation {
    let depth_m = model.well.path.last_md_m();
    let pressing = common::pressing(kind, depth_m, 40e3).rotary_speed_rad_per_s(rpm(60.0));
    Operation { bit_torque_N_m: 2e3, ..pressing }
}

/// Small motions about the string at rest; None where it locks up.
fn motions(model: &Model, kind: OperationKind, settings: &StiffSettings) -> Option<SmallMotions> {
    let dynamics = DynamicsSettings::default();
    SmallMotions::new(model, &operation(kind, model), settings, &dynamics).ok()
}

fn torsional_Hz(motions: &SmallMotions, count: usize) -> Vec<f64> {
    let found = motions.family(Family::Torsional, count).expect("modes");
    found.iter().map(|mode| mode.frequency_Hz).collect()
}

/// The first torsional frequencies of a string of uniform components that is held at the top and
/// free at the bit, Hz, by transfer matrices: twist and torque of a bar, from the bit up.
fn bars_Hz(model: &Model, count: usize) -> Vec<f64> {
    let top_turn = |frequency_Hz: f64| {
        let (mut turn, mut torque) = (1.0_f64, 0.0_f64);
        for span in model.string.spans() {
            let component = span.component;
            let wave = TAU
                * frequency_Hz
                * (component.material.density_kg_per_m3 / component.material.shear_modulus_Pa)
                    .sqrt();
            let impedance = component.torsional_stiffness_N_m2() * wave;
            let (sine, cosine) = (wave * (span.to_bit_m - span.from_bit_m)).sin_cos();
            (turn, torque) = (
                turn * cosine - torque * sine / impedance,
                turn * impedance * sine + torque * cosine,
            );
        }
        turn
    };
    const STEP_HZ: f64 = 1e-3;
    let mut found = Vec::new();
    let mut low = STEP_HZ;
    while found.len() < count {
        let (mut from, mut to) = (low, low + STEP_HZ);
        low = to;
        if top_turn(from) * top_turn(to) > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            if top_turn(from) * top_turn(middle) > 0.0 { from = middle } else { to = middle }
        }
        found.push(0.5 * (from + to));
    }
    found
}

/// Strings of these tests by name, of a bend and tool face in deg and a friction coefficient.
type Strings = [(&'static str, fn([f64; 2], f64) -> Model)];

/// The energy of a tool face is periodic, so that a string that turns has none on average: its
/// torsional frequencies are those of the straight string, and of bars by transfer matrices, at
/// every tool face. The mesh alone is left: of the tangent's fifth frequency, 1e-4 on the default
/// mesh and a quarter of that on half its length.
#[test]
fn a_bend_that_turns_has_the_torsional_modes_of_a_straight_string() {
    let strings: &Strings = &[("lateral", lateral), ("tangent", tangent)];
    let mut rows = Vec::new();
    for (name, string) in strings {
        for bend in [[0.0, 0.0], [1.5, 0.0], [1.5, 90.0], [1.5, 180.0]] {
            let model = string(bend, 0.3);
            let expected = bars_Hz(&model, 5);
            for kind in [OperationKind::Drill, OperationKind::RotateOffBottom] {
                let motions = motions(&model, kind, &StiffSettings::default()).expect("a state");
                assert!(!motions.leaves_its_tool_face());
                let [angle_deg, face_deg] = bend;
                let found = torsional_Hz(&motions, 5);
                rows
                    .extend(found.iter().zip(&expected).enumerate().map(|(index, (found, bars))| {
                    let what = format!(
                        "torsional mode {} of a {name} with a bend of {angle_deg} deg at tool face \
                        {face_deg} deg: {kind}, Hz",
                        index + 1
                    );
                    verify("modes", what)
                        .relative(2e-4, "the default mesh; half its elements leave a quarter")
                        .row(*bars, *found)
                }));
            }
        }
    }
    report_worst(rows);
}

/// Frequencies against bars converge with the square of the element length.
#[test]
fn a_finer_mesh_of_a_bent_string_is_nearer_to_bars() {
    let model = tangent([1.5, 180.0], 0.3);
    let expected = bars_Hz(&model, 5);
    let error = |length_m: f64| {
        let element_length = ElementLength::Uniform(length_m);
        let settings = StiffSettings { element_length, ..StiffSettings::default() };
        let motions = motions(&model, OperationKind::Drill, &settings).expect("a state");
        (torsional_Hz(&motions, 5)[4] / expected[4] - 1.0).abs()
    };
    let [coarse, fine] = [8.0, 4.0].map(error);
    assert!(fine < 0.3 * coarse && fine < 2e-5, "{coarse:e}, {fine:e}");
}

/// A string that slides has a tool face. One that is not held without friction is reported, and
/// none of the modes that vibrate is left out: a spring at the bend, of either sign, moves each to
/// at most the next of the straight string. The third of the tangent shares its energy with a
/// lateral mode, which moves it too.
#[test]
fn a_tool_face_of_a_sliding_string_that_nothing_holds_is_known() {
    let strings: &Strings = &[("lateral", lateral), ("tangent", tangent)];
    for (name, string) in strings {
        let straight = bars_Hz(&string([0.0, 0.0], 0.1), 5);
        let slides = |toolface_deg: f64| {
            let model = string([1.5, toolface_deg], 0.1);
            let settings = StiffSettings::default();
            let motions = motions(&model, OperationKind::Slide, &settings).expect("a state");
            assert!(motions.keeps_its_shape(), "{name}, {toolface_deg} deg");
            assert_eq!(motions.is_stable(), !motions.leaves_its_tool_face());
            (motions.leaves_its_tool_face(), torsional_Hz(&motions, 2))
        };
        let [(leaves, up), (of_side, side)] = [0.0, 90.0].map(slides);
        assert_eq!([leaves, of_side], [*name == "lateral", false], "{name}");
        // The first one of the lateral grows.
        let first = usize::from(leaves);
        for (index, found) in up.iter().enumerate() {
            let above = (index + first).checked_sub(1).map_or(0.0, |below| straight[below]);
            assert!(above < *found && *found < straight[index + first], "{name}: {up:?}");
        }
        for (index, found) in side.iter().enumerate() {
            assert!(straight[index] < *found && *found < straight[index + 1], "{name}: {side:?}");
        }
    }
}

/// No mode of any family has a frequency of zero, and no order meets one at rest: of unstable tool
/// faces, of a bow in a vertical hole, which rolls freely, of a string on a constant hook load,
/// which moves freely along the hole.
#[test]
fn no_mode_has_no_frequency() {
    let strings: &Strings = &[("lateral", lateral), ("tangent", tangent), ("vertical", vertical)];
    let kinds = [OperationKind::Drill, OperationKind::Slide, OperationKind::RotateOffBottom];
    let hook = DynamicsSettings {
        hoist_control: Some(HoistControl::HookLoad(5e5)),
        ..DynamicsSettings::default()
    };
    let mut left_out = 0;
    for (name, string) in strings {
        for bend in [[0.0, 0.0], [1.5, 0.0], [3.0, 180.0]] {
            let model = string(bend, 0.1);
            for kind in kinds {
                for dynamics in [&DynamicsSettings::default(), &hook] {
                    let operation = operation(kind, &model);
                    let settings = StiffSettings::default();
                    let motions = SmallMotions::new(&model, &operation, &settings, dynamics);
                    let motions = motions.expect("a state");
                    left_out += usize::from(motions.leaves_its_tool_face());
                    let assembly = motions.assembly(120.0);
                    let speed = motions.rotary_rad_per_s();
                    let lateral = assembly.lateral(0.0, 3, speed).expect("lateral modes");
                    let [axial, torsional] = [Family::Axial, Family::Torsional]
                        .map(|family| motions.family(family, 3).expect("modes"));
                    let others = [axial, torsional].concat();
                    let speeds = [0.0, 5.0, 10.0];
                    let diagram = assembly.campbell(3, &others, &speeds, &[1.0, 3.0]);
                    let modes: Vec<Mode> = [lateral, others].concat();
                    let what = format!("{name}, {bend:?} deg, {kind}");
                    assert_eq!(modes.len(), 9, "{what}");
                    for mode in modes {
                        let frequency_Hz = mode.frequency_Hz;
                        assert!(frequency_Hz >= 1e-3, "{what}: {:?} {frequency_Hz}", mode.family);
                    }
                    for critical in diagram.expect("a diagram").critical {
                        assert!(critical.rotary_rad_per_s > 1e-3, "{what}: {critical:?}");
                    }
                }
            }
        }
    }
    assert!(left_out > 0);
}
