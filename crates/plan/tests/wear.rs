//! Casing wear, against closed forms and quadrature.

mod common;

use std::f64::consts::PI;

use common::*;
use wholestring::{
    GRAVITY_M_PER_S2,
    prelude::*,
    string::ToolJoints,
    well::{CasingPipe, HoleKind, HoleSection},
};
use wholestring_judge::strength::{PSI_PA, Tube};
use wholestring_plan::{
    Stage, lengths_m,
    wear::{CasingError, CasingWear, Groove, WearFactors, WearRow, WornPipe, worn_m3_per_m},
};
use wholestring_verification::{report_worst, verify};

/// S6: volume by the wear factor, depth and width of the groove; and the wear of a joint that stays
/// in place. Closed forms, checked by quadrature in the file.
#[test]
fn s6_grooves() {
    let data = verification("S6_casing_wear.json");
    let mut compared = Vec::new();
    for case in data["cases"].as_array().expect("cases") {
        let input = |key: &str| number(&case["inputs"], key);
        let expected = |key: &str| number(&case["expected"], key);
        let revolutions = input("rpm") * 60.0 * input("hours");
        let sliding_m = revolutions * PI * input("tool_joint_od_m");
        let factor = input("wear_factor_1_per_psi") / PSI_PA;
        let worn = worn_m3_per_m(factor, input("side_force_N_per_m_of_pipe"), sliding_m);
        let groove =
            Groove { bore_m: 0.5 * input("casing_id_m"), joint_m: 0.5 * input("tool_joint_od_m") };
        let depth_m = groove.depth_m(worn).expect("a groove");
        let wall_m = 0.5 * (input("casing_od_m") - input("casing_id_m"));
        let name = format!(
            "{:.1} mm joint, {:.0} N/m for {:.0} h",
            1e3 * input("tool_joint_od_m"),
            input("side_force_N_per_m_of_pipe"),
            input("hours"),
        )
        .replace(", ", " under ");
        for (what, unit, computed, key) in [
            ("volume", "m³/m", worn, "volume_m3_per_m"),
            ("depth", "m", depth_m, "groove_depth_m"),
            ("wear", "%", 100.0 * depth_m / wall_m, "wear_percent_of_wall"),
            ("half width", "m", groove.half_width_m(depth_m), "groove_half_width_m"),
            ("area", "m²", groove.area_m2(depth_m), "volume_m3_per_m"),
        ] {
            compared.push((
                format!("{what} of the groove of a {name}, {unit}"),
                computed,
                expected(key),
            ));
        }
    }
    let (input, expected) =
        (&data["joint_fraction"]["inputs"], &data["joint_fraction"]["expected"]);
    let q_N_per_m = number(input, "side_force_per_pipe_m_N");
    let sliding_m = 1e6 * PI * number(input, "tj_od_m");
    let on_joint = q_N_per_m * number(input, "spacing_m") / number(input, "joint_length_m");
    for (what, force, key) in [
        ("passes", q_N_per_m, "V_per_casing_m_moving_after_1e6_rev_WF_3e10"),
        ("stays", on_joint, "V_local_static"),
    ] {
        let worn = worn_m3_per_m(3e-10 / PSI_PA, force, sliding_m);
        compared.push((
            format!("volume where the joint {what}, m³/m"),
            worn,
            number(expected, key),
        ));
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S6", what)
            .relative(1e-9, "rounding of the file's constants and its root")
            .row(*expected, *computed)
    }));
}

/// From a groove of a nanometre to one of a joint's diameter the depth is that of its area, and the
/// area that of a quadrature.
#[test]
fn depth_and_area_are_inverse() {
    let groove = Groove { bore_m: 0.110249, joint_m: 0.08414 };
    for depth_m in [1e-9, 1e-6, 1e-4, 3e-4, 1e-3, 1e-2, 0.05, 0.1, 0.16] {
        let area_m2 = groove.area_m2(depth_m);
        let again_m = groove.depth_m(area_m2).expect("a groove");
        assert_close("depth", again_m, depth_m, 1e-11);
        // In polar angle from the bore's axis: ½ (r² − R²) over where the joint reaches beyond the
        // bore.
        let apart_m = groove.bore_m - groove.joint_m + depth_m;
        let reach = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            let square = groove.joint_m.powi(2) - (apart_m * sin).powi(2);
            (square >= 0.0).then(|| apart_m * cos + square.sqrt())
        };
        if depth_m > 0.05 {
            continue;
        }
        let end = (groove.half_width_m(depth_m) / groove.bore_m).min(1.0).asin();
        let steps = 2000;
        let value =
            |angle: f64| reach(angle).map_or(0.0, |r| (r - groove.bore_m) * (r + groove.bore_m));
        // Simpson's rule on one half.
        let step = end / f64::from(steps);
        let sum: f64 = (0..=steps)
            .map(|i| {
                let weight = if i == 0 || i == steps {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                weight * value(step * f64::from(i))
            })
            .sum();
        // The difference of two lengths of 0.1 m has an error of 1e-17 m.
        assert_close("area", area_m2, sum * step / 3.0, 1e-9 + 1e-16 / depth_m);
    }
    assert_eq!(groove.depth_m(0.0), Some(0.0));
    assert_eq!(groove.depth_m(PI * 0.09_f64.powi(2)), None);
    assert_eq!(Groove { bore_m: 0.08, joint_m: 0.08 }.depth_m(1e-6), None);
    assert_eq!(groove.depth_m(f64::NAN), None);
}

const JOINT_OD_M: f64 = 0.16828;
const FACTOR_PER_PA: f64 = 2e-10 / PSI_PA;
const CASING: CasingPipe = CasingPipe { od_m: 0.244475, yield_strength_Pa: Some(80e3 * PSI_PA) };

fn factors() -> WearFactors {
    WearFactors { usual_per_Pa: 9e-10 / PSI_PA, of_section_per_Pa: vec![(0, FACTOR_PER_PA)] }
}

fn pipe_left(row: &WearRow) -> WornPipe {
    row.pipe.expect("a casing that is known")
}

/// A level hole, cased in its first 1000 m, and a pipe in air that weighs 1500 N/m.
fn level() -> Model {
    let station = |md_m| Station::from_degrees(md_m, 90.0, 0.0);
    let path = Path::minimum_curvature(&[station(0.0), station(2000.0)]).expect("a path");
    // Around the hole the friction is four fifths of that along it.
    let friction = Friction { around: 0.8, ..Friction::uniform(0.25) };
    let hole = Hole::new(vec![
        HoleSection {
            casing: Some(CASING),
            friction,
            ..HoleSection::casing(0.0..1002.0, 0.220498, 0.25)
        },
        HoleSection::open(1002.0..2000.0, 0.2159, 0.25),
    ])
    .expect("a hole");
    let pipe = ComponentSpec {
        mass_per_length_kg_per_m: 1500.0 / GRAVITY_M_PER_S2,
        joints: Some(ToolJoints { od_m: JOINT_OD_M, spacing_m: 9.6 }),
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ToSurface, steel())
    };
    let string = StringSpec { components: vec![pipe] }.assemble(2000.0).expect("a string");
    Model::new(Well { path, hole }, string, Mud::of_density(0.0))
}

/// S6 through the whole path: a pipe that weighs 1500 N/m turns in level casing for 100 h at 120
/// rpm. By its side force, and by the work of its friction.
#[test]
fn s6_through_the_whole_path() {
    let data = verification("S6_casing_wear.json");
    let expected = |key: &str| number(&data["cases"][0]["expected"], key);
    let model = level();
    let turn = Operation::rotate_off_bottom(2000.0).rotary_speed_rad_per_s(4.0 * PI);
    let solved = soft_string(&model, &turn).expect("a sound model");
    let stage = Stage {
        model: &model,
        operation: &turn,
        solution: (&solved).into(),
        duration_s: 100.0 * 3600.0,
    };
    let [by_force, by_work] = [CasingWear::add, CasingWear::add_by_work].map(|add| {
        let mut wear = CasingWear::new(&model.well.hole, &factors()).expect("casing");
        add(&mut wear, &stage);
        wear.rows()
    });
    assert_eq!(by_force.len(), 201);
    let mut rows = Vec::new();
    for (by, wear) in [("side force", &by_force), ("work", &by_work)] {
        for row in wear {
            let at = format!("by its {by} at {:.1} m", row.md_m);
            let depth_m = row.groove_m.expect("a groove");
            // The last 2 m of casing share a step of the hole's work with the rock.
            if row.md_m < 1000.0 {
                rows.push((
                    format!("depth of the groove {at}, m"),
                    depth_m,
                    expected("groove_depth_m"),
                ));
                rows.push((
                    format!("part of the wall that is gone {at}, %"),
                    100.0 * pipe_left(row).worn_part(),
                    expected("wear_percent_of_wall"),
                ));
            }
        }
    }
    report_worst(rows.iter().map(|(what, computed, expected)| {
        verify("S6", what).relative(1e-6, "the file's").row(*expected, *computed)
    }));
    // Remaining strength: Barlow by the wall, the collapse of a pipe with that wall all round.
    let row = pipe_left(&by_force[100]);
    let [new_Pa, worn_Pa] = row.burst_Pa.expect("a grade");
    assert_close("burst", worn_Pa / new_Pa, row.wall_left_m / row.wall_m, 1e-12);
    let thin = Tube {
        od_m: CASING.od_m,
        id_m: CASING.od_m - 2.0 * row.wall_left_m,
        yield_strength_Pa: 80e3 * PSI_PA,
    };
    let [_, worn_Pa] = row.collapse_Pa.expect("a grade");
    assert_close("collapse", worn_Pa, thin.collapse(0.0).pressure_Pa, 1e-9);
    // API TR 5C3 prints 4750 psi for 9-5/8 in 47 lb/ft L-80 (from memory).
    let [new_Pa, _] = row.collapse_Pa.expect("a grade");
    assert_close("collapse as printed", new_Pa / PSI_PA, 4750.0, 2e-3);
}

/// A campaign in parts wears as one does; a string that moves slides so much farther; drilling by
/// parts from depth to depth is all of it.
#[test]
fn a_campaign_is_its_stages() {
    let model = level();
    let drill = Operation::drill(2000.0)
        .rotary_speed_rad_per_s(10.0)
        .rate_of_penetration_m_per_s(5e-3)
        .weight_on_bit_N(1e4)
        .bit_torque_N_m(1e3);
    let solved = soft_string(&model, &drill).expect("a sound model");
    let worn = |lengths_m: &[f64]| {
        let mut wear = CasingWear::new(&model.well.hole, &factors()).expect("casing");
        for length_m in lengths_m {
            let stage = Stage::moved(&model, &drill, &solved, *length_m).expect("it moves");
            wear.add(&stage);
        }
        wear.rows()[50].worn_m3_per_m
    };
    let whole = worn(&[600.0]);
    let sliding_m = (600.0 / 5e-3 * 10.0 * 0.5 * JOINT_OD_M).hypot(600.0);
    let expected = worn_m3_per_m(FACTOR_PER_PA, 1500.0, sliding_m);
    assert_close("volume", whole, expected, 1e-9);
    let depths_m = [1400.0, 1500.0, 1800.0, 2000.0];
    let parts = lengths_m(&depths_m, 1400.0);
    assert_eq!(parts, [50.0, 200.0, 250.0, 100.0]);
    assert_close("parts", worn(&parts), whole, 1e-12);
    assert!(Stage::moved(&model, &Operation::rotate_off_bottom(2000.0), &solved, 1.0).is_none());
    assert!(lengths_m(&[], 0.0).is_empty());
    // The first depth represents the hole above it.
    assert_eq!(lengths_m(&depths_m, 900.0), [550.0, 200.0, 250.0, 100.0]);
    assert_eq!(lengths_m(&[7.0], 0.0), [7.0]);
    assert_eq!(lengths_m(&depths_m, 1600.0), [0.0, 50.0, 250.0, 100.0]);
    assert_eq!(lengths_m(&depths_m, 9000.0), [0.0; 4]);
}

/// Worn through is reported, not a negative wall.
#[test]
fn worn_through() {
    let model = level();
    let turn = Operation::rotate_off_bottom(2000.0).rotary_speed_rad_per_s(4.0 * PI);
    let solved = soft_string(&model, &turn).expect("a sound model");
    for hours in [1e4, 1e9] {
        let stage = Stage {
            model: &model,
            operation: &turn,
            solution: (&solved).into(),
            duration_s: hours * 3600.0,
        };
        let mut wear = CasingWear::new(&model.well.hole, &factors()).expect("casing");
        wear.add(&stage);
        let row = wear.rows()[20];
        let left = pipe_left(&row);
        assert!(row.groove_m.is_none_or(|depth_m| depth_m > left.wall_m), "{row:?}");
        assert_eq!((left.wall_left_m, left.worn_part()), (0.0, 1.0));
        assert_eq!(left.burst_Pa.expect("a grade")[1], 0.0);
        assert_eq!(left.collapse_Pa.expect("a grade")[1], 0.0);
    }
    // Zero without rotation, too.
    let wear = CasingWear::new(&model.well.hole, &factors()).expect("casing").rows();
    let whole = |row: &WearRow| pipe_left(row).wall_left_m == pipe_left(row).wall_m;
    assert!(wear.iter().all(|row| row.groove_m == Some(0.0) && whole(row)));
}

/// Casing that cannot be worn is refused with its mistake; casing whose pipe is not known has a
/// groove, but no remaining strength.
#[test]
fn casing_that_is_none() {
    let model = level();
    let refused =
        |factors: WearFactors| CasingWear::new(&model.well.hole, &factors).expect_err("wrong");
    assert_eq!(model.well.hole.sections()[1].kind, HoleKind::Open);
    for section in [1, 9] {
        let of_section_per_Pa = vec![(section, 1e-14)];
        let error = refused(WearFactors { of_section_per_Pa, ..WearFactors::default() });
        assert_eq!(error, CasingError::NotCased { section });
    }
    for factor_per_Pa in [0.0, -1.0, f64::NAN] {
        let of_section_per_Pa = vec![(0, factor_per_Pa)];
        let error = refused(WearFactors { of_section_per_Pa, ..WearFactors::default() });
        assert!(matches!(error, CasingError::Factor { section: 0, .. }), "{error}");
    }
    let with = |casing: Option<CasingPipe>| {
        let mut sections = model.well.hole.sections().to_vec();
        sections[0].casing = casing;
        CasingWear::new(&Hole::new(sections).expect("a hole"), &WearFactors::default())
    };
    for od_m in [0.2, 0.220498, f64::NAN, f64::INFINITY] {
        let error = with(Some(CasingPipe { od_m, ..CASING })).expect_err("wrong");
        assert!(matches!(error, CasingError::NoWall { .. }), "{error}");
    }
    assert!(with(None).expect("casing").rows().iter().all(|row| row.pipe.is_none()));
    let ungraded = CasingPipe { yield_strength_Pa: None, ..CASING };
    let rows = with(Some(ungraded)).expect("casing").rows();
    assert!(rows.iter().all(|row| pipe_left(row).burst_Pa.is_none()));
}
