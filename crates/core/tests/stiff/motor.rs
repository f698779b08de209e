//! Static BHA analysis: a bent motor by the three-moment theorem, sag between two supports, the
//! influence of the pipe above, tool faces.

use wholestring::{
    ends::TopEnd,
    prelude::*,
    statics::assembly::{self, Assembly, AssemblySettings, Extent, in_straight_hole, zeros},
    string::{Blades, BodyBend, ComponentLength, ComponentSpec, ToolJoints},
};

use crate::{common, common::verify, pressed, settings};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// A collar without weight in a mud that is as heavy.
fn collar(length_m: f64) -> ComponentSpec {
    let length = ComponentLength::Metres(length_m);
    ComponentSpec::uniform("collar", 0.17, 0.07, length, common::steel())
}

fn whole(element_length_m: f64) -> AssemblySettings {
    AssemblySettings { stiff: settings(element_length_m), extent: Extent::Whole, element_length_m }
}

/// A motor that touches at the bit, at its bend and at a stabiliser above, `a` and `b` apart, in an
/// arc of curvature `κ`: where `κ = 2 θ/(a + b)`, three points on a circle, the bend `θ` fits the
/// hole and does not press; elsewhere, by the three-moment theorem of a beam without shear, it adds
/// to the bit's side force
///
/// ```text
/// F = 3 EI (θ − κ (a + b)/2)/(a (a + b))
/// ```
///
/// The supports are blades with 10 µm of clearance. The force of a light pipe without a bend in a
/// straight hole is subtracted. Relative to the force of the bend in a straight hole, 22 kN, the
/// clearance causes an error of 2e-3, elements of 0.25 m 1e-4.
#[test]
fn a_bent_motor_on_three_points() {
    let (a_m, b_m, bent_rad) = (3.0, 7.0, 1.5 * DEGREE);
    let length_m = a_m + b_m;
    // Shear is negligible.
    let steel = Material { shear_modulus_Pa: 1e15, ..common::steel() };
    let piece = |length_m: f64| ComponentSpec { material: steel, ..collar(length_m) };
    let blades = Some(Blades { od_m: 0.3111, length_m: 0.02 });
    let stiffness_N_m2 = steel.youngs_modulus_Pa * std::f64::consts::PI / 64.0
        * (0.17_f64.powi(4) - 0.07_f64.powi(4));
    let per_rad_N = 3.0 * stiffness_N_m2 / (a_m * length_m);
    let fits_per_m = 2.0 * bent_rad / length_m;
    let force_N = |angle_rad: f64, toolface_rad: f64, curvature_per_m: f64| {
        let from = 50.0 - curvature_per_m * length_m / DEGREE;
        let path = common::arcs(&[[0.0, from, 0.0], [length_m, 50.0, 0.0]]);
        let bend = Some(BodyBend { from_lower_end_m: 0.05, angle_rad, toolface_rad });
        let parts = vec![
            piece(a_m - 0.05),
            ComponentSpec { blades, bend, ..piece(0.1) },
            piece(b_m - 0.05),
        ];
        let hole = common::open_hole(0.3111, 0.0, length_m);
        let mud = common::mud(0.9 * steel.density_kg_per_m3);
        let mut model = common::model(path, hole, parts, mud, length_m);
        model.ends.top = TopEnd::Pinned;
        let found = assembly::solve_once(&model, &pressed(length_m, 0.0), &whole(0.25));
        found.expect("an equilibrium").bit_side_force_N
    };
    let straight_N = force_N(0.0, 0.0, 0.0);
    for (toolface, part) in
        [(0.0, 0.0), (0.0, 0.5), (0.0, 1.0), (0.0, 1.5), (90.0, 0.0), (180.0, 0.0), (215.0, 0.0)]
    {
        let (toolface_rad, curvature_per_m) = (toolface * DEGREE, part * fits_per_m);
        let force_N = force_N(bent_rad, toolface_rad, curvature_per_m);
        let [high_N, right_N] = [0, 1].map(|side| force_N[side] - straight_N[side]);
        let (sine, cosine) = toolface_rad.sin_cos();
        let along_N = high_N * cosine + right_N * sine;
        let across_N = right_N * cosine - high_N * sine;
        let whole_N = per_rad_N * bent_rad;
        let name = format!(
            "side force of a motor bent by 1.5 deg over that in a straight hole: tool face {toolface} \
             deg and {part} of the curvature that it fits"
        );
        verify("three-point motor", name)
            .absolute(4e-3, "10 µm of room at the supports: 2e-3")
            .report(1.0 - part, along_N / whole_N);
        assert!(across_N.abs() < 4e-3 * whole_N, "{across_N} N aside");
    }
}

/// A beam between two supports `L` apart under `q = w sin i` is tilted by
/// `q (L³ − 6 L x² + 4 x³)/24 EI` at a distance `x` from the lower one, which points down and to
/// the low side more than the hole: the sensor there measures too little inclination below the
/// middle and too much above. Elements of 0.05 m, 0.2 m in the upper half: weight lumped at
/// the nodes causes an error of 1e-4. The hole is level, so that no tension holds the beam.
#[test]
fn sag_between_two_supports() {
    let length_m = 12.0;
    let inclination = 90.0;
    let path = common::arcs(&[[0.0, inclination, 30.0], [length_m, inclination, 30.0]]);
    let stiffness_N_m2 =
        210e9 * std::f64::consts::PI / 64.0 * (0.17_f64.powi(4) - 0.07_f64.powi(4));
    // The body has room for its deflection of 11 mm.
    for sensor_m in [2.0, 4.2, 9.0] {
        let part = ComponentSpec { survey_sensor_m: Some(sensor_m), ..collar(length_m) };
        let weight_N_per_m = part.mass_per_length_kg_per_m * wholestring::GRAVITY_M_PER_S2;
        let hole = common::open_hole(0.3, 0.0, length_m);
        let mut model = common::model(path.clone(), hole, vec![part], common::mud(0.0), length_m);
        model.ends.top = TopEnd::Pinned;
        let operation = Operation::trip_out(length_m);
        let found = assembly::solve(&model, &operation, &whole(0.05)).expect("rest");
        assert_eq!(found.contacts.len(), 1, "nothing but the bit: {:?}", found.contacts);
        let across_N_per_m = weight_N_per_m * inclination.to_radians().sin();
        let x = sensor_m;
        let turned = length_m.powi(3) - 6.0 * length_m * x * x + 4.0 * x.powi(3);
        // Going up the string it bows to the low side: below the middle it points up.
        let measured_more = across_N_per_m * turned / (24.0 * stiffness_N_m2);
        let sag = &found.sag[0];
        verify("sag", format!("correction of the inclination {sensor_m} m above a support, deg"))
            .relative(3e-4, "elements of 0.05 and 0.2 m: 1e-4; small slopes")
            .report(-measured_more / DEGREE, sag.inclination_rad / DEGREE);
        assert!(sag.azimuth_rad.expect("inclined").abs() < 1e-9);
        assert!((sag.hole_inclination_rad / DEGREE - inclination).abs() < 1e-9);
    }
}

/// Bit, motor with a bend and blades, MWD, stabiliser, collars, heavy-weight pipe and pipe in a
/// well that holds 40° below a build.
fn well(toolface: f64) -> (Model, Operation) {
    let steel = common::steel();
    let tube = |name: &str, od_m: f64, id_m: f64, length_m: f64| {
        ComponentSpec::uniform(name, od_m, id_m, ComponentLength::Metres(length_m), steel)
    };
    let bend = BodyBend { from_lower_end_m: 1.8, angle_rad: 1.2 * DEGREE, toolface_rad: toolface };
    let blades = |od_m: f64| Some(Blades { od_m, length_m: 0.4 });
    let parts = vec![
        ComponentSpec::bit(0.2159, 0.3),
        ComponentSpec { blades: blades(0.2127), ..tube("bearing housing", 0.1715, 0.12, 1.2) },
        ComponentSpec { bend: Some(bend), ..tube("motor", 0.1715, 0.12, 6.5) },
        ComponentSpec { blades: blades(0.2096), ..tube("stabiliser", 0.1715, 0.07, 1.5) },
        ComponentSpec { survey_sensor_m: Some(4.0), ..tube("MWD", 0.1715, 0.083, 9.0) },
        tube("collars", 0.1715, 0.0714, 54.0),
        ComponentSpec {
            joints: Some(ToolJoints { od_m: 0.168, spacing_m: 9.3 }),
            ..tube("HWDP", 0.127, 0.0762, 111.6)
        },
        ComponentSpec {
            joints: Some(ToolJoints { od_m: 0.168, spacing_m: 9.6 }),
            length: ComponentLength::ToSurface,
            ..tube("pipe", 0.127, 0.1086, 1.0)
        },
    ];
    let depth_m = 1500.0;
    let stations =
        [[0.0, 0.0, 20.0], [400.0, 0.0, 20.0], [900.0, 40.0, 20.0], [depth_m, 40.0, 20.0]];
    let hole = common::open_hole(0.2159, 0.25, depth_m);
    let model = common::model(common::arcs(&stations), hole, parts, common::mud(1200.0), depth_m);
    let operation = Operation { bit_torque_N_m: 4e3, ..pressed(depth_m, 80e3) };
    (model, operation)
}

fn once(model: &Model, operation: &Operation, extent: Extent) -> Assembly {
    let settings = AssemblySettings { extent, ..AssemblySettings::default() };
    assembly::solve_once(model, operation, &settings).expect("an equilibrium")
}

/// 100 m of pipe above the assembly are as good as 200 m and as the whole string: the side force
/// changes by less than 0.1 %, whatever the tool face and the operation.
#[test]
fn pipe_farther_up_does_not_matter() {
    for toolface in [0.0, 120.0 * DEGREE] {
        let (model, slide) = well(toolface);
        let drill = Operation {
            kind: OperationKind::Drill,
            rotary_speed_rad_per_s: common::rpm(60.0),
            rate_of_penetration_m_per_s: 3e-3,
            ..slide
        };
        for operation in [slide, drill, Operation::trip_out(slide.bit_depth_m)] {
            let force_N = |extent| once(&model, &operation, extent).bit_side_force_N;
            let [high_N, right_N] = force_N(Extent::PipeAbove(100.0));
            for other in [Extent::PipeAbove(200.0), Extent::Whole] {
                let [high, right] = force_N(other);
                let apart = (high - high_N).hypot(right - right_N) / high.hypot(right);
                assert!(apart < 1e-3, "{:?} {other:?}: {apart}", operation.kind);
            }
        }
    }
}

/// A string turned by a full revolution has the same side force. A bend to the right presses the
/// bit to the right, and the mean over a revolution is below the force with the bend on the high
/// side.
#[test]
fn a_tool_face_turns_the_side_force() {
    let (model, operation) = well(0.0);
    let at = |degrees: f64| {
        let string = model.string.at_toolface(degrees * DEGREE);
        assert!((string.toolface_rad().expect("a bend") - degrees * DEGREE).abs() < 1e-12);
        let model = Model { string, ..model.clone() };
        once(&model, &operation, Extent::PipeAbove(100.0)).bit_side_force_N
    };
    let [up, round] = [at(0.0), at(360.0)];
    assert!((up[0] - round[0]).hypot(up[1] - round[1]) < 1e-3 * up[0].abs());
    let (right, down, left) = (at(90.0), at(180.0), at(270.0));
    assert!(up[0] > 0.0 && down[0] < 0.0, "{up:?} {down:?}");
    assert!(right[1] > 0.0 && left[1] < 0.0, "{right:?} {left:?}");
    assert!(right[1] > 3.0 * (right[0] - 0.5 * (up[0] + down[0])).abs());
}

/// A pendulum drops, the more the steeper its hole is inclined; a fulcrum builds. In a hole that
/// builds the bit is pressed down more than in a straight one.
#[test]
fn inclination_and_curvature_of_a_straight_hole() {
    let (mut model, operation) = well(0.0);
    // Without the bend and the lower blades: a pendulum below a stabiliser at 9 m.
    let mut spec: Vec<ComponentSpec> = Vec::new();
    for span in model.string.spans() {
        let component = span.component;
        spec.push(ComponentSpec {
            joints: component.joints,
            blades: if component.name == "stabiliser" { component.blades } else { None },
            ..ComponentSpec::uniform(
                &component.name,
                component.od_m,
                component.id_m,
                ComponentLength::Metres(component.length_m),
                component.material,
            )
        });
    }
    model.string = StringSpec { components: spec }.assemble(operation.bit_depth_m).expect("one");
    let force_N = |inclination: f64, rate: f64| {
        let hole = in_straight_hole(&model, &operation, inclination * DEGREE, (rate, 150.0));
        once(&hole.expect("a hole"), &operation, Extent::PipeAbove(100.0)).bit_side_force_N[0]
    };
    let straight: Vec<(f64, f64)> =
        [10.0, 30.0, 60.0, 85.0].map(|degrees| (degrees, force_N(degrees, 0.0))).to_vec();
    assert!(straight.iter().all(|(_, force_N)| *force_N < 0.0), "{straight:?}");
    assert!(straight.windows(2).all(|pair| pair[1].1 < pair[0].1), "{straight:?}");
    assert!(zeros(&straight).is_empty());
    let [build, drop] = [3.0, -3.0].map(|rate| force_N(60.0, rate * DEGREE / 30.0));
    assert!(build < straight[2].1 && straight[2].1 < drop, "{build} {straight:?} {drop}");
}
