//! Loads of metal, joints and wear by the soft string, against closed forms.

mod common;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use common::*;
use serde_json::Value;
use wholestring::{
    GRAVITY_M_PER_S2,
    mud::Rheology,
    operation::OperationKind::*,
    outcome::HOLE_STEP_M,
    prelude::*,
    statics::{soft, soft::SoftSettings, span::BodyContact, span::JointSpan},
    string::{BodySection, Component, ToolJoints},
};

fn solve(model: &Model, operation: &Operation) -> SoftProfile {
    soft::solve(model, operation, &SoftSettings::default()).expect("a sound model")
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().expect(key)
}

/// The span of S1a's pipe between joints at this half spacing.
fn span(data: &Value, half_spacing_m: f64) -> JointSpan {
    let (pipe, joint_od_m) = (&data["inputs"]["pipe"], &data["inputs"]["tool_joint_od_m"]);
    JointSpan {
        bending_stiffness_N_m2: number(pipe, "EI"),
        half_spacing_m,
        standoff_m: 0.5 * (joint_od_m.as_f64().expect("a diameter") - number(pipe, "od")),
    }
}

/// S1a: a pipe that hangs between its tool joints in a build, whatever of its body touches:
/// curvature at the joints and half-way, and the touching part. The file's closed forms are ours in
/// another form, its body contacts a collocated boundary value problem: only rounding is left.
#[test]
fn s1a_spans_between_tool_joints() {
    let data = verification("S1a_tool_joints_in_build.json");
    let rows = data["periodic"].as_array().expect("rows");
    assert_eq!(rows.len(), 24);
    let mut compared = Vec::new();
    for row in rows {
        let (input, expected) = (&row["inputs"], &row["expected"]);
        let (tension_N, rate_deg) = (number(input, "T_N"), number(input, "dls_deg_30m"));
        let bent = span(&data, number(input, "half_spacing_m"))
            .bending(tension_N, number(expected, "q_N_per_m"));
        let regime = match bent.contact {
            BodyContact::None => "none",
            BodyContact::Middle => "point",
            BodyContact::Line => "line",
        };
        assert_eq!(expected["regime"], regime, "{input}");
        let hole_per_m = rate_deg.to_radians() / 30.0;
        let name = format!(
            "{:.0} kN in {rate_deg} deg/30 m at {} deg",
            tension_N / 1e3,
            number(input, "inc_deg")
        );
        for (what, beyond_per_m, key) in [
            ("at the joints", bent.at_joint_per_m, "curvature_at_TJ"),
            ("half-way", bent.at_middle_per_m, "curvature_mid"),
        ] {
            let what = format!("curvature {what} at {name}, 1/m");
            compared.push((what, hole_per_m + beyond_per_m, number(expected, key)));
        }
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S1a", what)
            .relative(1e-10, "the collocation of the body contacts; rounding elsewhere")
            .row(*expected, *computed)
    }));
}

/// S1a: a piece of twelve joints whose ends are pinned. From the third joint on, the tension of the
/// place and the equal spans are enough: the effect of the ends fades by a factor of nine from
/// joint to joint, 0.4 % at the third.
#[test]
fn s1a_a_piece_of_twelve_joints() {
    let data = verification("S1a_tool_joints_in_build.json");
    let piece = &data["finite"][0];
    let input = |key: &str| number(&piece["inputs"], key);
    let span = span(&data, 0.5 * input("joint_spacing_m"));
    let weight_N_per_m = number(&data["inputs"]["pipe"], "w");
    let hole_per_m = input("dls_deg_30m").to_radians() / 30.0;
    let top_rad = input("inc_top_deg").to_radians();
    let joints = piece["expected"]["tool_joints"].as_array().expect("joints");
    let found = joints[2..10].iter().map(|joint| {
        let at_m = number(joint, "s_m");
        let (sin, from) = ((top_rad + hole_per_m * at_m).sin(), top_rad.sin());
        let tension_N = input("T_top_N") - weight_N_per_m * (sin - from) / hole_per_m;
        let load_N_per_m = tension_N * hole_per_m - weight_N_per_m * sin;
        let bent = span.bending(tension_N, load_N_per_m);
        (
            format!("curvature at the joint {at_m:.1} m down a piece of twelve, 1/m"),
            hole_per_m + bent.at_joint_per_m,
            number(joint, "curvature_rad_m"),
        )
    });
    let found: Vec<_> = found.collect();
    report_worst(found.iter().map(|(what, computed, expected)| {
        verify("S1a", what)
            .relative(4e-3, "the ends of the piece, which fade ninefold from joint to joint")
            .row(*expected, *computed)
    }));
}

/// S3a: true tension and von Mises stress of a body under tension, bending, torque and pressures,
/// the largest of the two surfaces and sides. Closed forms: rounding is left.
#[test]
fn s3a_von_mises() {
    let data = verification("S3a_von_mises_points.json");
    let mut compared = Vec::new();
    for case in data["cases"].as_array().expect("cases") {
        let input = |key: &str| number(&case["inputs"], key);
        let expected = |key: &str| number(&case["expected"], key);
        let pipe = Component::uniform("pipe", input("od_m"), input("id_m"), 1.0, steel());
        let tension_N = input("effective_tension_N");
        let (inside_Pa, outside_Pa) = (input("p_inside_Pa"), input("p_outside_Pa"));
        let stress_Pa = BodySection::of(&pipe).von_mises_Pa(
            tension_N,
            input("bending_moment_Nm"),
            input("torque_Nm"),
            (inside_Pa - outside_Pa).powi(2),
        );
        let name = case["id"].as_str().expect("id").replace('_', " ");
        compared.push((
            format!("von Mises stress: {name}, Pa"),
            stress_Pa,
            expected("max_von_mises_Pa"),
        ));
        compared.push((
            format!("true tension: {name}, N"),
            pipe.true_tension_N(tension_N, outside_Pa, inside_Pa, 0.0),
            expected("true_axial_force_N"),
        ));
        let bending_Pa = input("bending_moment_Nm") / pipe.section_modulus_m3();
        let bent_Pa = expected("bending_stress_outer_Pa");
        assert!((bending_Pa - bent_Pa).abs() <= 1e-12 * bent_Pa, "{name}");
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S3a", what)
            .relative(1e-11, "rounding; forces that cancel lose two digits")
            .row(*expected, *computed)
    }));
    // Mud at rest presses alike from all sides.
    let pipe = Component::uniform("pipe", 0.127, 0.1086, 1.0, steel());
    assert_eq!(BodySection::of(&pipe).von_mises_Pa(0.0, 0.0, 0.0, 0.0), 0.0);
}

/// A05: the tension and the torque at which API RP 7G lets a body yield are the yield strength in
/// von Mises' stress: exactly, and but for the standard's 0.577002 in place of `1/√3`, 0.06 %.
#[test]
fn a05_yields_at_the_strength_of_the_standard() {
    let pipe = Component {
        yield_strength_Pa: Some(930.79e6),
        ..Component::uniform("pipe", 0.127, 0.1086, 1.0, steel())
    };
    let section = BodySection::of(&pipe);
    let yield_Pa = 930.79e6;
    let tension_N = pipe.tensile_yield_N().expect("graded");
    let pulled = section.von_mises_Pa(tension_N, 0.0, 0.0, 0.0);
    assert_close("pulled", pulled, yield_Pa, 1e-14);
    let torque_N_m = pipe.torsional_yield_N_m().expect("graded");
    let twisted = section.von_mises_Pa(0.0, 0.0, torque_N_m, 0.0);
    assert_close("twisted", twisted, 6.0 * 0.096167 * 3.0_f64.sqrt() * yield_Pa, 1e-12);
}

const JOINT_OD_M: f64 = 0.1683;
const SPACING_M: f64 = 9.6;
const YIELD_PA: f64 = 724e6;

/// Weightless pipe with tool joints: as dense as the mud.
fn jointed(joints: bool) -> ComponentSpec {
    ComponentSpec {
        joints: joints.then_some(ToolJoints { od_m: JOINT_OD_M, spacing_m: SPACING_M }),
        yield_strength_Pa: Some(YIELD_PA),
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel())
    }
}

/// A weightless string in an arc of 3 deg/30 m; the load of its bit is the tension everywhere.
fn in_an_arc(joints: bool, tension_N: f64) -> (Model, SoftProfile) {
    let length_m = 600.0;
    let model = along(
        &[[0.0, 0.0, 0.0], [length_m, 60.0, 0.0]],
        0.0,
        vec![jointed(joints)],
        mud(steel().density_kg_per_m3),
    );
    let drill = operation(Drill, length_m).weight_on_bit_N(-tension_N).bit_torque_N_m(5e3);
    let profile = solve(&model, &drill);
    (model, profile)
}

/// Without weight, the body bends by Lubinski's `x/tanh x` more than the hole at its joints under
/// tension and by `x/sinh x` half-way, in compression by `x/tan x` and `x/sin x`,
/// `x = (l/2)√(|T|/EI)`; a pipe without joints as the hole does. Moments, the bending stress and
/// von Mises' stress of the larger follow, and the sag. Rounding is left.
#[test]
fn joints_magnify_the_bending_of_a_hole() {
    let hole_per_m = 60.0_f64.to_radians() / 600.0;
    for (joints, tension_N) in [(true, 150e3), (true, -60e3), (false, 150e3), (false, -60e3)] {
        let (model, profile) = in_an_arc(joints, tension_N);
        let pipe = &model.string.components()[0];
        let stiffness = pipe.bending_stiffness_N_m2();
        let x = 0.5 * SPACING_M * (f64::abs(tension_N) / stiffness).sqrt();
        let magnifications = match (joints, tension_N > 0.0) {
            (false, _) => [1.0, 1.0],
            (true, true) => [x / x.tanh(), x / x.sinh()],
            (true, false) => [x / x.tan(), x / x.sin()],
        };
        let [at_joint_N_m, between_N_m] = magnifications.map(|by| stiffness * hole_per_m * by);
        let moment_N_m = at_joint_N_m.max(between_N_m);
        // Of `κ (l²/8 − (l/2x) (l/2) tanh(x/2))`, `tan` in compression.
        let half_m = 0.5 * SPACING_M;
        let arched_m =
            half_m * half_m / x * if tension_N > 0.0 { (0.5 * x).tanh() } else { (0.5 * x).tan() };
        let sag_m = hole_per_m * (0.5 * half_m * half_m - arched_m).abs();
        let bending_Pa = moment_N_m * 0.5 * pipe.od_m / pipe.second_moment_m4();
        let shear_Pa = 5e3 * 0.5 * pipe.od_m / pipe.polar_moment_m4();
        let normal_Pa = tension_N.abs() / pipe.area_m2() + bending_Pa;
        let von_mises_Pa = (normal_Pa.powi(2) + 3.0 * shear_Pa.powi(2)).sqrt();
        for row in [1, 300, 599] {
            let close = |what: &str, found: f64, expected: f64| {
                assert_close(&format!("{joints} {tension_N}: {what}"), found, expected, 1e-9);
            };
            close("at joints", profile.bending_moment_N_m[row], at_joint_N_m);
            close("between", profile.bending_moment_between_N_m[row], between_N_m);
            if joints {
                close("sag", profile.sag_m[row], sag_m);
            } else {
                assert_eq!(profile.sag_m[row], 0.0);
            }
            let touches = f64::from(u8::from(!joints));
            assert_eq!(profile.body_contact_fraction[row], touches);
            close("bending", profile.bending_stress_Pa[row], bending_Pa);
            close("stress", profile.von_mises_stress_Pa[row], von_mises_Pa);
            let used = profile.yield_use[row].expect("graded");
            close("use", used, von_mises_Pa / YIELD_PA);
            // Under tension it is on the high side, in compression on the low side.
            let per_joint = profile.side_force_per_joint_N[row];
            assert_eq!(per_joint.is_some(), joints);
            if let Some(force_N) = per_joint {
                close("joint", force_N, tension_N * hole_per_m * SPACING_M);
            }
            let climb_rad = profile.climb_rad[row].expect("it lies on a side");
            let expected = if tension_N > 0.0 { PI } else { 0.0 };
            assert!((climb_rad - expected).abs() < 1e-12, "{climb_rad}");
            let radius_m = 0.5 * if joints { JOINT_OD_M } else { pipe.od_m };
            close("offset", profile.lateral_offset_m[row], 0.15 - radius_m);
        }
    }
}

/// A string under tension in a turn is on its inside: to the right of the low side, looking down
/// the hole, where the azimuth grows, to the left where it falls.
#[test]
fn a_turn_climbs_to_its_inside() {
    for (to_deg, climb_rad) in [(90.0, FRAC_PI_2), (-90.0, -FRAC_PI_2)] {
        let length_m = 900.0;
        let model = along(
            &[[0.0, 90.0, 0.0], [length_m, 90.0, to_deg]],
            0.0,
            vec![jointed(true)],
            mud(steel().density_kg_per_m3),
        );
        let drill = pressing(Drill, length_m, -100e3);
        let found = solve(&model, &drill).climb_rad[450].expect("it lies on a side");
        assert!((found - climb_rad).abs() < 1e-9, "{found} for {climb_rad}");
    }
    // A vertical string that hangs free presses nowhere.
    let model = straight_model(0.0, 500.0, 300.0, 0.07, 0.3);
    let hanging = solve(&model, &operation(TripOut, 500.0));
    assert!(hanging.climb_rad.iter().all(Option::is_none));
}

/// Mud at rest presses by its weight inside and outside alike, and the end of a pipe that hangs in
/// it carries `−p A`; mud that flows leaves the annulus without pressure and enters the bore with
/// the pump's, and its stream adds `ρ Q²/A_i`.
#[test]
fn pressures_and_the_force_in_the_metal() {
    let length_m = 1000.0;
    let flow_m3_per_s = 0.03;
    let bingham = Rheology::Bingham { plastic_viscosity_Pa_s: 0.025, yield_point_Pa: 7.2 };
    for rheology in [None, Some(bingham)] {
        let mud = Mud { rheology, ..mud(1200.0) };
        let model =
            along(&[[0.0, 20.0, 0.0], [length_m, 20.0, 0.0]], 0.2, vec![jointed(true)], mud);
        let rotate = operation(RotateOffBottom, length_m)
            .flow_rate_m3_per_s(flow_m3_per_s)
            .bit_pressure_drop_Pa(5e6);
        let profile = solve(&model, &rotate);
        let pipe = &model.string.components()[0];
        let at_rest_Pa = 1200.0 * GRAVITY_M_PER_S2 * length_m * 20.0_f64.to_radians().cos();
        let added = profile.hydraulics.unwrap_or_default();
        let stream_N = match rheology {
            Some(_) => 1200.0 * flow_m3_per_s.powi(2) / (FRAC_PI_4 * pipe.id_m.powi(2)),
            None => 0.0,
        };
        let last = profile.md_m.len() - 1;
        let outside_Pa = at_rest_Pa + added.annulus_loss_Pa;
        let inside_Pa = outside_Pa + added.bit_loss_Pa;
        let close = |what: &str, found: f64, expected: f64| {
            let error = (found - expected).abs();
            assert!(error <= 1e-9 * at_rest_Pa, "{what}: {found} for {expected}");
        };
        close("outside", profile.outside_pressure_Pa[last], outside_Pa);
        close("inside", profile.inside_pressure_Pa[last], inside_Pa);
        close("top, outside", profile.outside_pressure_Pa[0], 0.0);
        close("top, inside", profile.inside_pressure_Pa[0], added.pump_pressure_Pa);
        let bore_m2 = pipe.inner_area_m2();
        let pressed_N = outside_Pa * (pipe.area_m2() + bore_m2) - inside_Pa * bore_m2;
        let true_N = profile.tension_N[last] - pressed_N + stream_N;
        close("true tension", profile.true_tension_N[last], true_N);
        assert_eq!(rheology.is_some(), added.annulus_loss_Pa > 0.0);
    }
}

/// Friction works at the speeds of the surface: the power on the hole adds up to that of friction's
/// torque and drag, to rounding, and a place's is `μ N V`. A stationary string has no friction
/// work.
#[test]
fn the_power_of_friction() {
    let (length_m, friction) = (803.0, 0.25);
    let model = uniform_model(
        &[[0.0, 30.0, 0.0], [400.0, 50.0, 40.0], [length_m, 50.0, 40.0]],
        300.0,
        0.07,
        friction,
    );
    for kind in [TripOut, TripIn, RotateOffBottom, Drill, Slide, Ream, BackReam] {
        let operation = operation(kind, length_m)
            .rate_of_penetration_m_per_s(0.01)
            .weight_on_bit_N(20e3)
            .bit_torque_N_m(1e3);
        let profile = solve(&model, &operation);
        let (axial, spin) = (operation.axial_velocity_m_per_s(), operation.rotation_rad_per_s());
        let scalars = &profile.scalars;
        let power_W = scalars.friction_torque_N_m * spin - scalars.axial_friction_N * axial;
        let on_the_hole = &profile.wear.wear_power_W_per_m;
        let sum_W: f64 = on_the_hole.iter().sum::<f64>() * HOLE_STEP_M;
        assert_close(kind.name(), sum_W, power_W, 1e-11);
        assert!(power_W > 0.0, "{power_W}");
        assert_eq!(profile.wear.md_m.last(), Some(&802.5));
        let row = 700;
        let speed = axial.hypot(spin * 0.07);
        let local = friction * profile.side_force_N_per_m[row].abs() * speed;
        assert_close(kind.name(), profile.wear_power_W_per_m[row], local, 1e-12);
        // In the tangent the load changes by less than 1e-3 from one stretch of hole to the next.
        let hole = on_the_hole[(profile.md_m[row] / HOLE_STEP_M) as usize];
        assert_close(kind.name(), hole, local, 2e-3);
    }
    let standing = operation(Slide, length_m).rate_of_penetration_m_per_s(0.0);
    let profile = solve(&model, &standing);
    assert!(profile.wear_power_W_per_m.iter().all(|power| *power == 0.0));
}

/// Joints without standoff hold nothing off the wall, and a component without a yield strength has
/// no use of it.
#[test]
fn flush_joints_and_unknown_strength() {
    let flush = ComponentSpec {
        joints: Some(ToolJoints { od_m: 0.127, spacing_m: SPACING_M }),
        yield_strength_Pa: None,
        material: Material { ..steel() },
        ..jointed(true)
    };
    let model = along(&[[0.0, 0.0, 0.0], [600.0, 60.0, 0.0]], 0.2, vec![flush], mud(0.0));
    let profile = solve(&model, &operation(TripOut, 600.0));
    let pipe = &model.string.components()[0];
    let expected = pipe.bending_stiffness_N_m2() * 60.0_f64.to_radians() / 600.0;
    assert_close("moment", profile.bending_moment_N_m[300], expected, 1e-9);
    assert_eq!(profile.yield_use[300], None);
}
