//! The reach of a tangent, against closed forms and independent integrations.

use serde_json::Value;
use wholestring::{
    mud::Rheology,
    prelude::*,
    statics::{
        buckling::Criterion,
        soft::{SoftSettings, solve},
    },
};
use wholestring_judge::{CheckKind, DepthLimit, DesignFactors};
use wholestring_plan::{
    Setup,
    reach::{Curve, End, ReachError, ReachSettings, first_stop, margins, reach, reach_unless},
    root,
};
use wholestring_verification::{Row, report_worst, verify};

fn verification(name: &str) -> Value {
    let path =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).expect("a file")).expect("JSON")
}

#[track_caller]
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// The uniform pipe of the studies along stations of MD in m and inclination in degrees.
fn setup(inputs: &Value, stations: &[[f64; 2]], friction: f64) -> Setup {
    let pipe = &inputs["pipe"];
    let stations: Vec<Station> =
        stations.iter().map(|[md_m, inc]| Station::from_degrees(*md_m, *inc, 0.0)).collect();
    let path = Path::minimum_curvature(&stations).expect("a path");
    let section = HoleSection::open(0.0..100e3, number(&inputs["hole_m"]), friction);
    let (area_m2, weight_N_per_m) = (number(&pipe["A"]), number(&pipe["w"]));
    let material = Material {
        // In a mud of no density: the same weight.
        density_kg_per_m3: weight_N_per_m / (area_m2 * wholestring::GRAVITY_M_PER_S2),
        youngs_modulus_Pa: number(&pipe["E"]),
        shear_modulus_Pa: number(&pipe["G"]),
        ..Material::STEEL
    };
    let pipe = ComponentSpec::uniform(
        "pipe",
        number(&pipe["od"]),
        number(&pipe["id"]),
        ToSurface,
        material,
    );
    Setup {
        well: Well { path, hole: Hole::new(vec![section]).expect("a hole") },
        string: StringSpec::from_bit(pipe),
        mud: Mud::of_density(0.0),
        fluids: Default::default(),
        rig: Rig {
            block_weight_N: Some(200e3),
            top_drive_torque_N_m: inputs["top_drive_limit_Nm"].as_f64(),
            ..Rig::default()
        },
        ends: Default::default(),
        buckling: Criterion::HeKyllingstad,
    }
}

fn operation(kind: OperationKind, inputs: &Value) -> Operation {
    Operation::new(kind, 0.0)
        .rotary_speed_rad_per_s(10.0)
        .weight_on_bit_N(number(&inputs["WOB_N"]))
        .bit_torque_N_m(number(&inputs["bit_torque_Nm"]))
}

const PLAIN: SoftSettings = SoftSettings { step_m: 5.0, helix_side_force: false };
const HELIX: SoftSettings = SoftSettings { step_m: 5.0, helix_side_force: true };

/// Required factors of one.
const ONE: DesignFactors = DesignFactors {
    tension: 1.0,
    torsion: 1.0,
    tension_and_torsion: 1.0,
    von_mises: 1.0,
    burst: 1.0,
    collapse: 1.0,
    make_up: 1.0,
    side_force: 1.0,
    hoist: 1.0,
    top_drive: 1.0,
    top_drive_peak: 1.0,
    breakaway: 1.0,
    pump_pressure: 1.0,
    sinusoidal_buckling: 1.0,
    helical_buckling: 1.0,
    lock_up: 1.0,
    overpull: 1.0,
};

/// Settings of a soft string, with required factors of one: the limits themselves.
fn of_soft(soft: SoftSettings) -> ReachSettings {
    ReachSettings { soft, factors: ONE, ..ReachSettings::from_depth(1000.0) }
}

/// Where a string slides with helix friction, its step; elsewhere the tolerance of the file.
fn s5_row(id: &str, key: &str, expected: f64, computed: f64) -> Row<'static> {
    let quantity = verify("S5", format!("{} of {id}, m", key.trim_end_matches("_md_m")));
    match key.contains("lockup") || key.contains("push_helical") {
        true => quantity.absolute(5.0, "the source's own step"),
        false => quantity.relative(3e-6, "steps of 2 m change 1.3e-6; the source holds 1e-4"),
    }
    .row(expected, computed)
}

/// Depths at which limits stop a tangent well: `S5`, its definitions one by one.
#[test]
fn s5_limits_of_a_tangent() {
    let file = verification("S5_reach.json");
    let inputs = &file["inputs"];
    let mut rows = Vec::new();
    for case in file["cases"].as_array().expect("cases") {
        let (id, own, expected) =
            (case["id"].as_str().unwrap(), &case["inputs"], &case["expected"]);
        let (end_m, inc) = (number(&own["eob_m"]), number(&own["inc_deg"]));
        let kick_off_m = number(&inputs["kop_m"]);
        let stations = [[0.0, 0.0], [kick_off_m, 0.0], [end_m, inc]];
        let vertical = setup(inputs, &stations, number(&own["mu"]));
        // The file counts buckling from the kick-off down: a casing as narrow as the pipe holds the
        // part above straight.
        let mut sections = vertical.well.hole.sections().to_vec();
        let narrow_m = number(&inputs["pipe"]["od"]);
        let casing = HoleSection::casing(0.0..kick_off_m, narrow_m, number(&own["mu"]));
        sections[0].from_md_m = kick_off_m;
        sections.insert(0, casing);
        let hole = Hole::new(sections).expect("a hole");
        let path = vertical.well.path.clone();
        let setup = Setup { well: Well { path, hole }, ..vertical.clone() };
        let settings = |soft, to_m| ReachSettings {
            to_m,
            depths: 16,
            soft,
            factors: ONE,
            ..ReachSettings::from_depth(end_m)
        };
        let reach_of = |kind, soft, to_m| {
            reach(&setup, &operation(kind, inputs), &settings(soft, to_m)).expect("a reach")
        };
        let drill = reach_of(OperationKind::Drill, PLAIN, 30e3);
        let turn = reach_of(OperationKind::RotateOffBottom, PLAIN, 30e3);
        let slack_off = reach_of(OperationKind::TripIn, PLAIN, 60e3);
        let slide = reach_of(OperationKind::Slide, PLAIN, 30e3);
        let helix = reach_of(OperationKind::Slide, HELIX, 30e3);
        let curve = |reach: &'_ wholestring_plan::reach::OperationReach, limit| -> Curve {
            let found = reach.curves.iter().find(|curve| curve.limit == limit);
            found.expect("the limit concerns it").clone()
        };
        for (key, curve) in [
            ("torque_limit_rotary_drilling_md_m", curve(&drill, DepthLimit::TopDrive)),
            ("torque_limit_off_bottom_md_m", curve(&turn, DepthLimit::TopDrive)),
            ("zero_slackoff_hook_load_md_m", curve(&slack_off, DepthLimit::HookLoadZero)),
            ("zero_slackoff_with_200kN_block_md_m", curve(&slack_off, DepthLimit::PushSpent)),
            ("zero_sliding_hook_load_with_WOB_md_m", curve(&slide, DepthLimit::HookLoadZero)),
            ("sinusoidal_onset_sliding_md_m", curve(&slide, DepthLimit::Sinusoid)),
            ("helical_onset_sliding_md_m", curve(&slide, DepthLimit::Helix)),
            (
                "slide_stops_with_200kN_push_no_helical_friction_md_m",
                curve(&slide, DepthLimit::PushSpent),
            ),
            (
                "slide_stops_with_200kN_push_helical_friction_md_m",
                curve(&helix, DepthLimit::PushSpent),
            ),
        ] {
            match (expected[key].as_f64(), curve.end) {
                (Some(depth_m), End::At(found_m)) => {
                    rows.push(s5_row(id, key, depth_m, found_m));
                }
                // The file has none either.
                (None, End::NoneTo(_)) => {}
                (expected, found) => panic!("{id} {key}: {expected:?}, {found:?}"),
            }
        }
        // Where the hook load is zero before the helix begins the file has none, because its helix
        // has had no friction yet.
        let [plain, rubbed] = [&slide, &helix].map(|reach| curve(reach, DepthLimit::HookLoadZero));
        assert!(expected["zero_sliding_hook_load_with_helical_friction_md_m"].is_null());
        assert_eq!(plain.end, rubbed.end);
        // The file has no block in its first limit.
        let alone = Setup { rig: Rig { block_weight_N: None, ..setup.rig }, ..setup.clone() };
        let kinds = [OperationKind::Drill, OperationKind::RotateOffBottom, OperationKind::Slide];
        let first = kinds.map(|kind| {
            let settings = settings(PLAIN, 30e3);
            reach(&alone, &operation(kind, inputs), &settings).expect("a reach")
        });
        let (first_stop, first) = first_stop(&first).expect("something stops it");
        let named = match (first_stop.kind, first.limit) {
            (OperationKind::Drill, DepthLimit::TopDrive) => "torque_limit_rotary_drilling_md_m",
            (OperationKind::Slide, DepthLimit::HookLoadZero) => {
                "zero_sliding_hook_load_with_WOB_md_m"
            }
            other => panic!("{other:?}"),
        };
        assert_eq!(expected["first_limit"], named);

        let at = &expected["at_4000m"];
        let loads = |kind| {
            let operation = Operation { bit_depth_m: 4e3, ..operation(kind, inputs) };
            margins(&setup, &operation, &of_soft(PLAIN)).expect("margins")
        };
        let load = |kind, limit| {
            loads(kind).iter().find(|load| load.limit == limit).expect("a margin").load
        };
        // The file stops where the compression is 3 MN, not where it is infinite.
        let pushed = |bit_depth_m: f64| {
            let slide = Operation { bit_depth_m, ..operation(OperationKind::Slide, inputs) };
            let profile = solve(&setup.at(bit_depth_m).expect("a model"), &slide, &HELIX);
            let least_N =
                profile.map(|profile| profile.tension_N.iter().copied().fold(0.0, f64::min));
            Ok::<f64, ReachError>(3e6 + least_N.unwrap_or(-9e6))
        };
        let key = "lockup_unlimited_push_md_m";
        let locks_m = curve(&helix, DepthLimit::PushAbsorbed).end.depth_m().expect("a depth");
        let ends = [0.9 * locks_m, locks_m].map(|depth_m| (depth_m, pushed(depth_m).unwrap()));
        let cut_m = root(pushed, ends, 0.01).expect("a depth");
        rows.push(s5_row(id, key, number(&expected[key]), cut_m));
        let row = verify("S5", format!("{}, of {id}, infinite push, m", &key[..key.len() - 5]));
        let row = row.any("the file stops at 3 MN");
        rows.push(row.row(number(&expected[key]), locks_m));
        // The loss in a helix in the vertical part, which the file does not count.
        let whole =
            reach(&vertical, &operation(OperationKind::Slide, inputs), &settings(HELIX, 30e3));
        let whole = whole.expect("a reach");
        for (key, limit) in [
            ("slide_stops_with_200kN_push_helical_friction_md_m", DepthLimit::PushSpent),
            ("lockup_unlimited_push_md_m", DepthLimit::PushAbsorbed),
        ] {
            let what =
                format!("{}, of {id} with a helix in vertical hole too, m", &key[..key.len() - 5]);
            let found_m = curve(&whole, limit).end.depth_m().expect("a depth");
            let row = verify("S5", what).any("the file counts none in its vertical hole");
            rows.push(row.row(number(&expected[key]), found_m));
        }
        for limit in [DepthLimit::Sinusoid, DepthLimit::Helix] {
            let [narrow_m, wide_m] =
                [&helix, &whole].map(|reach| curve(reach, limit).end.depth_m().expect("a depth"));
            assert!(wide_m <= narrow_m && narrow_m - wide_m < 300.0, "{wide_m} {narrow_m}");
        }
        assert!(curve(&whole, DepthLimit::VerticalHelix).end.depth_m() < Some(6e3));

        for (key, unit, computed) in [
            ("rot_drill_torque_Nm", "N·m", load(OperationKind::Drill, DepthLimit::TopDrive)),
            ("slackoff_N", "N", load(OperationKind::TripIn, DepthLimit::HookLoadZero)),
            ("sliding_N", "N", load(OperationKind::Slide, DepthLimit::HookLoadZero)),
        ] {
            let row = verify("S5", format!("{key} at 4000 m of {id}, {unit}"))
                .relative(3e-6, "steps of 2 m change 1.3e-6; the source holds 1e-4");
            rows.push(row.row(number(&at[key]), computed));
        }
    }
    report_worst(rows);
}

/// Where the inclination is below `atan(1/μ)`, a sliding string never stops.
#[test]
fn below_the_critical_inclination_there_is_no_limit() {
    let file = verification("S5_reach.json");
    let inputs = &file["inputs"];
    for (mu, stops) in [(0.26_f64, false), (0.28, true)] {
        // atan(1/μ) is 75.4° and 74.4°.
        assert_eq!((1.0 / mu).atan().to_degrees() < 75.0, stops);
        let setup = setup(inputs, &[[0.0, 0.0], [400.0, 0.0], [1150.0, 75.0]], mu);
        let settings = ReachSettings {
            to_m: 99e3,
            depths: 12,
            soft: PLAIN,
            ..ReachSettings::from_depth(1150.0)
        };
        let off_bottom = operation(OperationKind::TripIn, inputs);
        let found = reach(&setup, &off_bottom, &settings).expect("a reach");
        let curve =
            found.curves.iter().find(|curve| curve.limit == DepthLimit::HookLoadZero).unwrap();
        assert_eq!(curve.end.depth_m().is_some(), stops, "{:?}", curve.end);
        if !stops {
            assert_eq!(curve.end, End::NoneTo(99e3));
            // The hanging weight grows with depth.
            assert!(curve.margins.windows(2).all(|pair| pair[1].load > pair[0].load));
        }
    }
}

/// Length of a horizontal string that locks up, in closed form: `S2b`.
#[test]
fn s2b_lock_up_of_a_horizontal_well() {
    let file = verification("S2b_lockup_horizontal.json");
    let inputs = &file["inputs"];
    let mut rows = Vec::new();
    for case in file["cases"].as_array().expect("cases") {
        let (own, expected) = (&case["inputs"], &case["expected"]);
        let rule = own["F_hel_rule"].as_str().unwrap();
        let setup = setup(inputs, &[[0.0, 90.0], [100.0, 90.0]], number(&own["mu"]));
        let buckling = match rule {
            "WuJuvkamWold" => Criterion::WuJuvkamWold,
            _ => Criterion::ChenLinCheatham,
        };
        // A rig that pushes with 1000 kN.
        let rig = Rig { block_weight_N: Some(1e6), ..Rig::default() };
        let setup = Setup { buckling, rig, ..setup };
        let slide = Operation::slide(0.0).weight_on_bit_N(number(&own["F_at_bit_N"]));
        let found = |step_m: f64| {
            let soft = SoftSettings { step_m, helix_side_force: true };
            let settings = ReachSettings {
                to_m: 8e3,
                depths: 9,
                soft,
                tolerance_m: 1e-6,
                ..ReachSettings::from_depth(100.0)
            };
            let found = reach(&setup, &slide, &settings).expect("a reach");
            [DepthLimit::Helix, DepthLimit::PushSpent, DepthLimit::PushAbsorbed].map(|limit| {
                let curve = found.curves.iter().find(|curve| curve.limit == limit);
                curve.expect("a limit").end.depth_m().expect("a depth")
            })
        };
        let [onset_m, push_m, locks_m] = found(0.5);
        // At the usual step, ten times as long.
        let [.., usual_m] = found(5.0);
        assert!((usual_m - locks_m).abs() < 0.5, "{usual_m} {locks_m}");
        let name = |what: &str| {
            format!("{what} of {rule}, bit at {} kN, m", number(&own["F_at_bit_N"]) / 1e3)
        };
        for (what, key, found_m) in [
            ("helix begins", "onset_of_helix_from_bit_m", onset_m),
            ("length for 1000 kN", "length_for_1000kN_push_m", push_m),
        ] {
            let row = verify("S2b", name(what)).relative(1e-6, "the requirement of its source");
            rows.push(row.row(number(&expected[key]), found_m));
        }
        rows.push(
            verify("S2b", name("reach until it locks up"))
                .absolute(0.05, "at a step of 0.5 m 0.004 m is left")
                .row(number(&expected["closed_form_m"]), locks_m),
        );
    }
    report_worst(rows);
}

/// A string that is nearly locked up transmits little of its push, a straight one in a straight
/// hole all of it, and one in a build the fraction of the capstan equation.
#[test]
fn what_arrives_of_a_push() {
    let file = verification("S5_reach.json");
    let mu = 0.3_f64;
    let setup = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], mu);
    let arrives = |length_m: f64, wob_N: f64| {
        let slide = Operation::slide(length_m).weight_on_bit_N(wob_N);
        let all = margins(&setup, &slide, &of_soft(HELIX)).expect("margins");
        let margin =
            all.iter().find(|margin| margin.limit == DepthLimit::PushAbsorbed).expect("a margin");
        let forces = solve(&setup.at(length_m).unwrap(), &slide, &HELIX).unwrap().scalars;
        (margin.margin, -forces.hook_load_N)
    };
    assert!((arrives(1000.0, 1e4).0 - 1.0).abs() < 1e-9);
    // Beyond the helix `dF/dx = μ (w + b F²)`: pushes at both ends grow in the ratio of their
    // rates.
    let place = wholestring::statics::buckling::Place::of(&setup.at(3e3).unwrap(), 3e3, 1e3);
    let rate = |push_N: f64| place.weight_N_per_m + place.helix_load_N_per_m(push_N);
    let (wob_N, length_m) = (300e3, 500.0);
    let (share, top_N) = arrives(length_m, wob_N);
    let expected = rate(wob_N) / rate(top_N);
    // A difference over 1e-3 of the weight, 1.1e2 N: half of it times the second derivative.
    assert!((share / expected - 1.0).abs() < 1e-3, "{share} {expected}");
}

#[test]
fn depths_must_grow() {
    let file = verification("S5_reach.json");
    let setup = setup(&file["inputs"], &[[0.0, 0.0], [100.0, 0.0]], 0.3);
    let settings = ReachSettings { to_m: 900.0, ..ReachSettings::from_depth(1000.0) };
    let refused = reach(&setup, &Operation::trip_in(0.0), &settings).unwrap_err();
    assert_eq!(refused, ReachError::Depths { from_m: 1000.0, to_m: 900.0 });
    assert_eq!(
        refused.to_string(),
        "the reach is requested from 1000 m to 900 m, which is not deeper"
    );
}

/// A reach that is stopped ends at the next depth, without a result.
#[test]
fn a_reach_that_is_stopped_ends_at_the_next_depth() {
    let file = verification("S5_reach.json");
    let setup = setup(&file["inputs"], &[[0.0, 0.0], [1000.0, 0.0]], 0.3);
    let settings = ReachSettings { to_m: 5000.0, ..ReachSettings::from_depth(1000.0) };
    let calls = std::cell::Cell::new(0);
    let after_three = || {
        calls.set(calls.get() + 1);
        calls.get() > 3
    };
    let stopped = reach_unless(&setup, &Operation::trip_in(0.0), &settings, &after_three);
    assert_eq!(stopped, Err(ReachError::Stopped));
    assert_eq!(calls.get(), 4);
}

/// A string that hangs in a vertical well stops where its weight and the block equal the capacity
/// of the hoist, and where its weight yields its uppermost section.
#[test]
fn a_hanging_string_stops_at_hoist_and_yield() {
    let file = verification("S5_reach.json");
    let inputs = &file["inputs"];
    let mut setup = setup(inputs, &[[0.0, 0.0], [1000.0, 0.0]], 0.3);
    let (block_N, capacity_N, yields_Pa) = (200e3, 1500e3, 500e6);
    setup.rig.hoist_capacity_N = Some(capacity_N);
    setup.string.components[0].yield_strength_Pa = Some(yields_Pa);
    let (weight_N_per_m, area_m2) = (number(&inputs["pipe"]["w"]), number(&inputs["pipe"]["A"]));
    let settings =
        ReachSettings { to_m: 12e3, depths: 12, factors: ONE, ..ReachSettings::from_depth(1000.0) };
    let pick_up = reach(&setup, &Operation::trip_out(0.0), &settings).expect("a reach");
    let depth_m = |limit| {
        let curve = pick_up.curves.iter().find(|curve| curve.limit == limit).expect("a limit");
        (curve.end.depth_m().expect("a depth"), curve.there)
    };
    let rounding = "the weight from mass and area";
    let (hoist_m, there) = depth_m(DepthLimit::Hoist);
    verify("reach", "depth at which the hoist carries no more, m")
        .relative(1e-6, rounding)
        .report((capacity_N - block_N) / weight_N_per_m, hoist_m);
    assert!((there.load / capacity_N - 1.0).abs() < 1e-5 && there.at_md_m.is_none());
    let (yields_m, there) = depth_m(DepthLimit::Yield);
    verify("reach", "depth at which the pipe's own weight yields it, m")
        .relative(1e-6, rounding)
        .report(yields_Pa * area_m2 / weight_N_per_m, yields_m);
    assert_eq!(there.at_md_m, Some(0.0));
    let first = [pick_up];
    let (_, first) = first_stop(&first).expect("a stop");
    assert_eq!(first.limit, DepthLimit::Hoist);
}

/// The torque at the surface meets the make-up torque of the topmost connection at the depth at
/// which it meets an equal rating of the top drive, and the torsional yield with a required factor
/// of two where it meets half of the yield.
#[test]
fn a_string_that_turns_stops_at_its_connections() {
    let file = verification("S5_reach.json");
    let inputs = &file["inputs"];
    let mut setup = setup(inputs, &[[0.0, 0.0], [1000.0, 0.0], [1500.0, 75.0]], 0.3);
    let turn = Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(10.0);
    let capacity_N_m = 15e3;
    setup.rig.top_drive_torque_N_m = Some(capacity_N_m);
    let connection = &mut setup.string.components[0].connection;
    connection.make_up_torque_N_m = Some(capacity_N_m);
    connection.torsional_yield_N_m = Some(2.0 * capacity_N_m);
    let factors = DesignFactors { torsion: 2.0, ..ONE };
    let settings =
        ReachSettings { to_m: 12e3, depths: 12, factors, ..ReachSettings::from_depth(1600.0) };
    let found = reach(&setup, &turn, &settings).expect("a reach");
    let depth_m = |limit| {
        let curve = found.curves.iter().find(|curve| curve.limit == limit).expect("a limit");
        (curve.end.depth_m().expect("a depth"), curve.there)
    };
    let (expected_m, _) = depth_m(DepthLimit::TopDrive);
    for limit in [DepthLimit::MakeUp, DepthLimit::Torsion] {
        let (found_m, there) = depth_m(limit);
        assert!((found_m - expected_m).abs() < 1e-6 * expected_m, "{limit:?} {found_m}");
        assert!((there.load - capacity_N_m).abs() < 1e-5 * capacity_N_m, "{there:?}");
        assert_eq!(there.at_md_m, Some(0.0));
    }
}

/// A level hole is not vertical, locked up or not; one that begins vertical is there. The wall of
/// the level hole holds the pipe by 2.83 sqrt(EI w/r), the weight in a vertical one by 5.55 (EI
/// w²)^(1/3).
#[test]
fn a_level_hole_has_no_vertical_stretch() {
    let file = verification("S5_reach.json");
    let level = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], 0.3);
    let turned = setup(&file["inputs"], &[[0.0, 0.0], [300.0, 0.0], [900.0, 90.0]], 0.3);
    let named = |setup: &Setup, depth_m: f64| {
        let slide = Operation::slide(depth_m).weight_on_bit_N(50e3);
        let all = margins(setup, &slide, &of_soft(HELIX)).expect("margins");
        all.iter().map(|margin| margin.limit).collect::<Vec<DepthLimit>>()
    };
    for depth_m in [1000.0, 20_000.0] {
        let limits = named(&level, depth_m);
        assert!(limits.contains(&DepthLimit::Helix), "{limits:?}");
        assert!(!limits.contains(&DepthLimit::VerticalHelix), "{limits:?}");
        assert!(named(&turned, depth_m).contains(&DepthLimit::VerticalHelix));
    }
}

/// In a vertical well the sinusoid of a pushed string is that of the vertical hole, which `run` and
/// `plan` report too; the one of an inclined hole is not met.
#[test]
fn a_vertical_hole_has_a_sinusoid_of_its_own() {
    let file = verification("S5_reach.json");
    let vertical = setup(&file["inputs"], &[[0.0, 0.0], [1500.0, 0.0]], 0.3);
    let slide = Operation::slide(1500.0).weight_on_bit_N(50e3);
    let all = margins(&vertical, &slide, &of_soft(HELIX)).expect("margins");
    let margin = |limit| all.iter().find(|margin| margin.limit == limit).expect("it concerns");
    assert!(margin(DepthLimit::VerticalSinusoid).margin < 0.0, "{all:?}");
    assert_eq!(margin(DepthLimit::Sinusoid).margin, 1.0, "{all:?}");
}

/// The helix of no hole begins before its sinusoid: places are vertical or inclined for both shapes
/// alike, also in a hole that is nearly vertical.
#[test]
fn a_helix_begins_after_its_sinusoid() {
    let file = verification("S5_reach.json");
    let (mut buckled, mut both) = (0, 0);
    let holes = [0.0, 0.3, 0.6, 1.0, 2.0, 4.0].map(|inclination| [inclination; 2]);
    // A curve holds the pipe of a hole that is nearly vertical.
    let curved = [[0.0, 2.0], [0.0, 5.0], [0.0, 10.0], [0.0, 20.0], [0.0, 40.0], [3.0, 0.0]];
    for inclination in holes.into_iter().chain(curved) {
        let [above, below] = inclination;
        let well = setup(&file["inputs"], &[[0.0, above], [1500.0, below]], 0.3);
        for weight_kN in (5..60).step_by(5).chain([80, 120, 200]) {
            let slide = Operation::slide(1500.0).weight_on_bit_N(1e3 * f64::from(weight_kN));
            let all = margins(&well, &slide, &of_soft(PLAIN)).expect("margins");
            let margin =
                |limit| all.iter().find(|margin| margin.limit == limit).map(|margin| margin.margin);
            for (sinusoid, helix) in [
                (DepthLimit::VerticalSinusoid, DepthLimit::VerticalHelix),
                (DepthLimit::Sinusoid, DepthLimit::Helix),
            ] {
                let (Some(first), Some(then)) = (margin(sinusoid), margin(helix)) else { continue };
                assert!(first <= then, "{inclination:?} deg, {weight_kN} kN: {first} {then}");
                buckled += usize::from(then < 0.0);
                both += usize::from(first < 0.0);
            }
        }
    }
    assert!(buckled > 20 && both > buckled, "{buckled} {both}");
}

/// Hoist and make-up torque that are exceeded by exactly the same part at the first depth already:
/// the headline names the limit that the verdict of the operation names.
#[test]
fn an_equal_tie_has_one_limit() {
    let file = verification("S5_reach.json");
    let inputs = &file["inputs"];
    let mut setup = setup(inputs, &[[0.0, 0.0], [1000.0, 0.0], [1500.0, 75.0]], 0.3);
    let turn = Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(10.0);
    let pick_up = Operation::trip_out(0.0);
    let settings =
        ReachSettings { to_m: 4e3, depths: 4, factors: ONE, ..ReachSettings::from_depth(1600.0) };
    let with = |setup: &mut Setup, hoist_N: f64, make_up_N_m: f64| {
        setup.rig.hoist_capacity_N = Some(hoist_N);
        setup.string.components[0].connection.make_up_torque_N_m = Some(make_up_N_m);
        [&pick_up, &turn].map(|operation| reach(setup, operation, &settings).expect("a reach"))
    };
    let [_, turned] = with(&mut setup, 1e9, 1e9);
    let load = |limit| {
        let curve = turned.curves.iter().find(|curve| curve.limit == limit).expect("it concerns");
        curve.margins[0].load
    };
    // Half of a number is exact, so that both margins are -1.
    let (hoist_N, make_up_N_m) = (0.5 * load(DepthLimit::Hoist), 0.5 * load(DepthLimit::MakeUp));
    let [_, tied] = with(&mut setup, hoist_N, make_up_N_m);
    let equal = tied.curves.iter().filter(|curve| {
        curve.stops && curve.end == End::Already(1600.0) && curve.there.margin == -1.0
    });
    let equal: Vec<DepthLimit> = equal.map(|curve| curve.limit).collect();
    assert_eq!(equal.len(), 2, "{:?}", tied.curves);
    let (_, verdict) = tied.stop().expect("a stop");
    assert!(equal.contains(&verdict.limit));
    let alone = [tied.clone()];
    let (_, headline) = first_stop(&alone).expect("a stop");
    assert_eq!(headline.limit, verdict.limit);
    // Of two operations of the same limits, too, the headline is the verdict of the one it names.
    let reaches = [tied.clone(), tied];
    let (reach, headline) = first_stop(&reaches).expect("a stop");
    let (_, verdict) = reach.stop().expect("a stop");
    assert_eq!(headline.limit, verdict.limit);
}

/// A well with a dogleg of 24 deg/30 m in its build, and pipe with 300 m of heavy-weight pipe in it.
fn dogleg() -> Setup {
    let stations = [
        [0.0, 0.0],
        [600.0, 0.0],
        [1200.0, 30.0],
        [2500.0, 30.0],
        [2515.0, 42.0],
        [2900.0, 85.0],
        [3100.0, 85.0],
    ];
    let stations: Vec<Station> =
        stations.iter().map(|[md_m, inc]| Station::from_degrees(*md_m, *inc, 0.0)).collect();
    let path = Path::minimum_curvature(&stations).expect("a path");
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..2500.0, 0.2205, 0.22),
        HoleSection::open(2500.0..100e3, 0.2159, 0.3),
    ]);
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.25))
        .catalogue("5 in 19.50 lb/ft G-105", Metres(620.0))
        .and_then(|string| string.catalogue("HWDP 5 in 49.3 lb/ft", Metres(300.0)))
        .and_then(|string| string.catalogue("5 in 19.50 lb/ft S-135", ToSurface));
    Setup {
        well: Well::new(path, hole.expect("a hole")),
        string: string.expect("a string"),
        mud: Mud::of_density(1200.0),
        fluids: Default::default(),
        rig: Rig::default(),
        ends: Default::default(),
        buckling: Default::default(),
    }
}

/// A stiff component that passes a dogleg between two depths of the grid stops the string there:
/// a scan in steps of 5 m finds no stress above the limit before the reach does.
#[test]
fn a_stiff_component_in_a_dogleg_is_not_stepped_over() {
    let setup = dogleg();
    let mut passed = 0;
    for from_m in [3110.0, 3200.0, 3270.0, 3330.0, 3400.0] {
        let settings = ReachSettings { factors: ONE, ..ReachSettings::from_depth(from_m) };
        let step_m = settings.grid_m()[1] - from_m;
        let at = |bit_depth_m: f64, von_mises: f64| {
            let factors = DesignFactors { von_mises, ..ONE };
            let settings = ReachSettings { factors, ..settings };
            let all = margins(&setup, &Operation::trip_out(bit_depth_m), &settings);
            let all = all.expect("margins");
            all.iter().find(|margin| margin.limit == DepthLimit::Yield).expect("a yield").margin
        };
        // A factor between the largest stresses at two depths of the grid and those between them.
        let scan_m: Vec<f64> = (1..)
            .map(|step| from_m + 5.0 * f64::from(step))
            .take_while(|m| *m < from_m + step_m)
            .collect();
        let ends = at(from_m, 1.0).min(at(from_m + step_m, 1.0));
        let least = scan_m.iter().map(|depth_m| at(*depth_m, 1.0)).fold(1.0, f64::min);
        if least > ends - 0.005 {
            continue;
        }
        passed += 1;
        let von_mises = 1.0 / (1.0 - 0.5 * (ends + least));
        let factors = DesignFactors { von_mises, ..ONE };
        let found =
            reach(&setup, &Operation::trip_out(0.0), &ReachSettings { factors, ..settings });
        let found = found.expect("a reach");
        let (stop_m, curve) = found.stop().expect("a stop");
        assert_eq!(curve.limit, DepthLimit::Yield);
        assert!(stop_m < from_m + step_m, "{from_m}: {stop_m}");
        let first_m = scan_m.iter().find(|depth_m| at(**depth_m, von_mises) <= 0.0);
        assert!(Some(&stop_m) <= first_m, "{from_m}: {stop_m} {first_m:?}");
    }
    assert!(passed >= 2, "{passed}");
}

/// A string that is locked up at its first depth is stopped because any push is absorbed; of the
/// other limits nothing is known.
#[test]
fn a_string_that_is_locked_up_has_no_other_limits() {
    let file = verification("S5_reach.json");
    let mut level = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], 0.3);
    level.string.components[0].yield_strength_Pa = Some(900e6);
    let settings = ReachSettings { to_m: 30e3, depths: 3, ..ReachSettings::from_depth(20e3) };
    let slide = Operation::slide(0.0).weight_on_bit_N(50e3);
    let found = reach(&level, &slide, &settings).expect("a reach");
    assert!(found.curves.len() > 4);
    for curve in &found.curves {
        match curve.limit {
            DepthLimit::PushAbsorbed => assert_eq!(curve.end, End::Already(20e3)),
            _ => assert_eq!(curve.end, End::LockedUp(20e3), "{:?}", curve.limit),
        }
    }
    let (_, stop) = found.stop().expect("a stop");
    assert_eq!(stop.limit, DepthLimit::PushAbsorbed);
}

/// Every operation loads the hoist, the pump delivers, and a string at rest is started: a reach
/// stops where run and plan find a limit exceeded, and names what was not checked.
#[test]
fn limits_of_the_rig_stop_every_operation() {
    let mut setup = dogleg();
    for section in [0.25, 0.4] {
        let friction = Friction { at_rest: 1.5 * section, ..Friction::uniform(section) };
        setup = setup.with_friction_of(|_| friction).expect("a setup");
    }
    setup.mud.rheology = Some(Rheology::Newtonian { viscosity_Pa_s: 0.03 });
    setup.rig = Rig {
        hoist_capacity_N: Some(600e3),
        pump_pressure_limit_Pa: Some(5e6),
        top_drive_peak_torque_N_m: Some(8e3),
        ..Rig::default()
    };
    let settings = ReachSettings { depths: 9, ..ReachSettings::from_depth(3110.0) };
    let drill = Operation::drill(0.0)
        .weight_on_bit_N(50e3)
        .bit_torque_N_m(1e3)
        .rotary_speed_rad_per_s(10.0)
        .rate_of_penetration_m_per_s(3e-3)
        .flow_rate_m3_per_s(0.035);
    let turn = Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(10.0);
    for (operation, limits) in [
        (
            drill,
            &[
                DepthLimit::Hoist,
                DepthLimit::PumpPressure,
                DepthLimit::TopDrive,
                DepthLimit::Strength,
            ][..],
        ),
        (turn, &[DepthLimit::Hoist, DepthLimit::Breakaway][..]),
    ] {
        let found = reach(&setup, &operation, &settings).expect("a reach");
        for limit in limits {
            let curve = found.curves.iter().find(|curve| curve.limit == *limit);
            let depth_m = curve.expect("it concerns").end.depth_m();
            assert!(depth_m.is_some() || *limit == DepthLimit::Strength, "{limit:?}");
        }
        let lacks = found.unchecked.iter().map(|unchecked| unchecked.kind);
        assert!(lacks.into_iter().any(|kind| kind == CheckKind::TopDrive));
    }
}
