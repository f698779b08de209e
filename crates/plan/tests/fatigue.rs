//! Fatigue, against the stated rule by closed forms, and through the whole path.

mod common;

use std::f64::consts::PI;

use common::*;
use serde_json::Value;
use wholestring::{
    prelude::*,
    statics::span::JointSpan,
    string::{Component, ToolJoints},
};
use wholestring_judge::strength::PSI_PA;
use wholestring_plan::{
    Stage,
    fatigue::{
        CELL_M, Damage, EnduranceCurve, FatigueSettings, SnCurve, equivalent_amplitude_Pa,
        minimum_tensile_strength_Pa, permissible_dogleg_rad_per_m, rows,
    },
};
use wholestring_verification::{report_worst, verify};

/// The curve that S3c states, a rule for tests.
const RULE: SnCurve = SnCurve::of_one_slope(2e6, 138e6, 5.0);
const TENSILE_PA: f64 = 1000e6;

fn s3c() -> Value {
    verification("S3c_fatigue.json")
}

/// The file's pipe with tool joints of half a spacing, m.
fn jointed(data: &Value, half_spacing_m: f64) -> Component {
    let number = |key: &str| number(&data["pipe"], key);
    let joints = ToolJoints { od_m: 0.1683, spacing_m: 2.0 * half_spacing_m };
    Component { joints: Some(joints), ..pipe(number("od"), number("id"), 75e3 * PSI_PA) }
}

/// S3c: curvature at the joint, stress, Goodman, cycles and damage of a joint that is drilled
/// through three sections, and Miner's sum.
#[test]
fn s3c_three_sections() {
    let data = s3c();
    let weight_N_per_m = number(&data["pipe"], "w");
    let mut compared = Vec::new();
    let case = &data["cases"][0];
    let mut sum = 0.0;
    for section in case["sections"].as_array().expect("sections") {
        let input = |key: &str| number(&section["inputs"], key);
        let (tension_N, rate) = (input("T_N"), (input("dls_deg_30m") / 30.0).to_radians());
        let body = jointed(&data, 4.8);
        let load = tension_N * rate - weight_N_per_m * input("inc_deg").to_radians().sin();
        let span = JointSpan::of(&body).expect("joints");
        // Where the lateral load exceeds the effect of tension, the joints bend it the other way.
        let beyond = span.bending(tension_N, load.abs()).at_joint_per_m.copysign(load);
        let curvature_per_m = rate + beyond;
        let bending_Pa = 210e9 * curvature_per_m.abs() * 0.5 * body.od_m;
        let mean_Pa = tension_N / body.area_m2();
        let equivalent_Pa = equivalent_amplitude_Pa(bending_Pa, mean_Pa, TENSILE_PA);
        let revolutions = input("length_m") / input("rop_m_h") * 60.0 * input("rpm");
        let cycles = RULE.cycles(equivalent_Pa);
        let name = format!("in {} deg/30 m", input("dls_deg_30m"));
        for (what, unit, computed, key) in [
            ("curvature at the joint", ", 1/m", curvature_per_m, "curvature_at_joint"),
            ("bending", ", Pa", bending_Pa, "bending_amplitude_Pa"),
            ("mean stress", ", Pa", mean_Pa, "mean_stress_Pa"),
            ("equivalent stress", ", Pa", equivalent_Pa, "goodman_equivalent_Pa"),
            ("revolutions", "", revolutions, "revolutions"),
            ("cycles to failure", "", cycles, "cycles_to_failure"),
            ("damage", "", revolutions / cycles, "damage"),
        ] {
            let expected = number(&section["expected"], key);
            compared.push((format!("{what} {name}{unit}"), computed, expected));
        }
        sum += revolutions / cycles;
    }
    compared.push((
        "damage of three sections".into(),
        sum,
        number(&case["expected"], "total_damage"),
    ));
    let passes = number(&case["expected"], "passes_to_failure");
    compared.push(("passes to failure".into(), 1.0 / sum, passes));
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S3c", what).relative(1e-6, "the file's; rounding").row(*expected, *computed)
    }));
}

/// S3c: Lubinski's permissible dogleg severity of E-75.
#[test]
fn s3c_permissible_dogleg() {
    let data = s3c();
    let mut compared = Vec::new();
    for case in data["lubinski"]["cases"].as_array().expect("cases") {
        let tension_N = number(&case["inputs"], "T_N");
        let body = jointed(&data, number(&case["inputs"], "half_joint_m"));
        let endured = EnduranceCurve::E75.bending_Pa(tension_N / body.area_m2()) / PSI_PA;
        let dogleg = permissible_dogleg_rad_per_m(&body, tension_N, EnduranceCurve::E75);
        let name = format!("under {:.0} kN", tension_N / 1e3);
        let expected = |key: &str| number(&case["expected"], key);
        compared.push((
            format!("bending that is endured {name}, psi"),
            endured,
            expected("max_bending_psi"),
        ));
        compared.push((
            format!("permissible dogleg {name}, deg/30 m"),
            30.0 * dogleg.to_degrees(),
            expected("permissible_dls_deg_30m"),
        ));
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S3c", what).relative(1e-6, "the file's; rounding").row(*expected, *computed)
    }));
    assert_eq!(EnduranceCurve::of(75e3 * PSI_PA), EnduranceCurve::E75);
    assert_eq!(EnduranceCurve::of(135e3 * PSI_PA), EnduranceCurve::S135);
    // The endurance limit is zero beyond the end of a curve, and a compression does not increase
    // the bending of a joint.
    assert_eq!(EnduranceCurve::E75.bending_Pa(67_001.0 * PSI_PA), 0.0);
    assert_eq!(EnduranceCurve::S135.bending_Pa(133_401.0 * PSI_PA), 0.0);
    assert_close("S-135", EnduranceCurve::S135.bending_Pa(-1.0) / PSI_PA, 20_000.0, 1e-12);
    let body = jointed(&data, 4.65);
    let [pushed, none] = [-1e5, 0.0]
        .map(|tension_N| permissible_dogleg_rad_per_m(&body, tension_N, EnduranceCurve::E75));
    assert_eq!(pushed, none);
}

/// The default curve has its two slopes meet at the knee, and both are the printed ones.
#[test]
fn the_curve_of_the_default() {
    let curve = SnCurve::default();
    for (range_MPa, exponent, log) in
        [(400.0_f64, 4.0, 15.117), (150.0, 4.0, 15.117), (60.0, 5.0, 17.146)]
    {
        let printed = 10_f64.powf(log) / range_MPa.powf(exponent);
        // Printed to 0.001 of the logarithm, 0.2 %.
        assert_close("cycles", curve.cycles(0.5e6 * range_MPa), printed, 3e-3);
    }
    let [above, below] =
        [1.0 + 1e-12, 1.0 - 1e-12].map(|over| curve.cycles(over * curve.knee_amplitude_Pa));
    assert_close("at the knee", above, below, 1e-10);
    assert_eq!(curve.cycles(0.0), f64::INFINITY);
    let endured = SnCurve { endurance_limit_Pa: Some(50e6), ..curve };
    assert_eq!(endured.cycles(49e6), f64::INFINITY);
    assert_eq!(endured.cycles(51e6), curve.cycles(51e6));
}

/// Goodman by hand, and the strengths of the grades.
#[test]
fn mean_stress_and_grades() {
    assert_close("half", equivalent_amplitude_Pa(80e6, 500e6, 1000e6), 160e6, 1e-15);
    assert_eq!(equivalent_amplitude_Pa(80e6, -500e6, 1000e6), 80e6);
    assert_eq!(equivalent_amplitude_Pa(80e6, 1000e6, 1000e6), f64::INFINITY);
    assert_close("S-135", minimum_tensile_strength_Pa(931e6) / PSI_PA, 145e3, 1e-12);
    assert_eq!(minimum_tensile_strength_Pa(500e6), 500e6);
}

/// A weightless string in an arc, under the pull of its bit: tension and curvature are the same
/// everywhere.
fn in_an_arc(length_m: f64, tension_N: f64) -> (Model, Operation) {
    let data = s3c();
    let body = jointed(&data, 4.8);
    let spec = ComponentSpec {
        joints: body.joints,
        yield_strength_Pa: body.yield_strength_Pa,
        ..ComponentSpec::uniform("pipe", body.od_m, body.id_m, ToSurface, steel())
    };
    let degrees = length_m / 10.0;
    let path = Path::minimum_curvature(&[
        Station::from_degrees(0.0, 0.0, 0.0),
        Station::from_degrees(length_m, degrees, 0.0),
    ])
    .expect("a path");
    let hole = Hole::new(vec![HoleSection::open(0.0..length_m, 0.2159, 0.0)]).expect("a hole");
    let components = vec![
        ComponentSpec {
            mass_per_length_kg_per_m: 1.0,
            ..ComponentSpec::uniform("bit", 0.2, 0.1, Metres(3.3), steel())
        },
        spec,
    ];
    let string = StringSpec { components }.assemble(length_m).expect("a string");
    let mud = Mud::of_density(steel().density_kg_per_m3);
    let operation = Operation::drill(length_m)
        .rotary_speed_rad_per_s(4.0 * PI)
        .rate_of_penetration_m_per_s(15.0 / 3600.0)
        .weight_on_bit_N(-tension_N)
        .bit_torque_N_m(1e3);
    (Model::new(Well { path, hole }, string, mud), operation)
}

/// Through the whole path: in an arc of 3 deg/30 m without weight the pipe bends by `x coth x` more
/// at its joints, each hour turns 7200 times, and the damage is uniform along the whole pipe.
#[test]
fn damage_along_a_string_that_drills() {
    let settings = FatigueSettings { sn_curve: RULE, tensile_strength_Pa: Some(TENSILE_PA) };
    let tension_N = 4e5;
    let (model, drill) = in_an_arc(600.0, tension_N);
    let solved = soft_string(&model, &drill).expect("a sound model");
    let body = &model.string.components()[1];
    let x = 4.8 * (tension_N / body.bending_stiffness_N_m2()).sqrt();
    let rate = (0.1_f64).to_radians();
    let bending_Pa = 210e9 * rate * x / x.tanh() * 0.5 * body.od_m;
    let equivalent_Pa = bending_Pa / (1.0 - tension_N / body.area_m2() / TENSILE_PA);
    let per_hour = 7200.0 / (2e6 * (138e6 / equivalent_Pa).powi(5));
    let mut compared = Vec::new();
    for row in rows(&model, &drill, &(&solved).into(), &settings) {
        assert!(row.component == 1);
        let at = format!("at {:.0} m of a string that drills", row.md_m);
        compared.push((format!("bending {at}, Pa"), row.bending_Pa, bending_Pa));
        compared.push((format!("damage per hour {at}, 1/h"), row.damage_per_hour, per_hour));
        assert_close("dogleg", row.dogleg_rad_per_m, rate, 1e-9);
        let permissible = row.permissible_dogleg_rad_per_m.expect("a grade");
        let expected = permissible_dogleg_rad_per_m(body, tension_N, EnduranceCurve::E75);
        assert_close("permissible", permissible, expected, 1e-9);
    }
    assert!(compared.len() > 1000);
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S3c", what)
            .relative(1e-8, "rounding, five times of the stress")
            .row(*expected, *computed)
    }));

    let mut damage = Damage::default();
    for length_m in [30.0, 60.0] {
        let stage = Stage::moved(&model, &drill, &solved, length_m).expect("it drills");
        assert_close("revolutions", stage.revolutions(), length_m / 15.0 * 7200.0, 1e-12);
        damage.add(&stage, &settings);
    }
    let pipe: Vec<_> = damage.rows().filter(|row| row.component == 1).collect();
    assert_eq!(pipe.len(), (596.7 / CELL_M).ceil() as usize);
    for row in &pipe {
        assert_close("damage", row.damage, 6.0 * per_hour, 1e-8);
    }
    let worst = damage.worst(1).expect("the pipe");
    assert_close("worst", worst.damage, 6.0 * per_hour, 1e-8);
    assert!(damage.worst(7).is_none());
}

/// The same metal moves down the hole: the damage of one depth adds up in the joints that the next
/// depth damages further, and pipe that is added later has only the later damage.
#[test]
fn pipe_is_added_at_the_surface() {
    let settings = FatigueSettings { sn_curve: RULE, tensile_strength_Pa: Some(TENSILE_PA) };
    let mut damage = Damage::default();
    let mut each = Vec::new();
    for (length_m, tension_N) in [(400.0, 5e5), (600.0, 3e5)] {
        let (model, drill) = in_an_arc(length_m, tension_N);
        let solved = soft_string(&model, &drill).expect("a sound model");
        let stage = Stage::moved(&model, &drill, &solved, 90.0).expect("it drills");
        let mut alone = Damage::default();
        alone.add(&stage, &settings);
        each.push(alone.worst(1).expect("the pipe").damage);
        damage.add(&stage, &settings);
    }
    for row in damage.rows().filter(|row| row.component == 1) {
        let old = row.from_lower_end_m < 396.7;
        let expected = if old { each[0] + each[1] } else { each[1] };
        assert_close("damage", row.damage, expected, 1e-8);
    }
    // A string that does not turn has no damage.
    let (model, drill) = in_an_arc(400.0, 5e5);
    let slide = Operation::slide(400.0)
        .weight_on_bit_N(-5e5)
        .bit_torque_N_m(1e3)
        .rate_of_penetration_m_per_s(drill.rate_of_penetration_m_per_s);
    let solved = soft_string(&model, &slide).expect("a sound model");
    let mut still = Damage::default();
    still.add(&Stage::moved(&model, &slide, &solved, 90.0).expect("it moves"), &settings);
    assert!(still.rows().all(|row| row.damage == 0.0));
}

/// Where a pipe meets a thicker component, each is damaged by its own bending: in the soft string
/// both have the curvature of the hole.
#[test]
fn neighbours_damage_each_other_not() {
    let settings = FatigueSettings { sn_curve: RULE, tensile_strength_Pa: Some(TENSILE_PA) };
    let (mut model, drill) = in_an_arc(400.0, 1e5);
    let part = |name, od_m, length| ComponentSpec::uniform(name, od_m, 0.0714, length, steel());
    let components = vec![part("pipe", 0.127, Metres(200.0)), part("collar", 0.2032, ToSurface)];
    model.string = StringSpec { components }.assemble(400.0).expect("a string");
    let solved = soft_string(&model, &drill).expect("a sound model");
    let mut damage = Damage::default();
    let stage = Stage::moved(&model, &drill, &solved, 90.0).expect("it drills");
    damage.add(&stage, &settings);
    for (index, body) in model.string.components().iter().enumerate() {
        let bending_Pa = 210e9 * 0.1_f64.to_radians() * 0.5 * body.od_m;
        let equivalent_Pa = bending_Pa / (1.0 - 1e5 / body.area_m2() / TENSILE_PA);
        let expected = stage.revolutions() / RULE.cycles(equivalent_Pa);
        let worst = damage.worst(index).expect("a tensile strength").damage;
        assert_close(&body.name, worst, expected, 1e-8);
    }
}
