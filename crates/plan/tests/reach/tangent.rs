//! Limits of a tangent and of a horizontal well: `S5`, `S2b`.

use wholestring_verification::{Row, file, report_worst, verify};

use super::*;

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
    let file = file("S5_reach.json");
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
    let file = file("S5_reach.json");
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
    let file = file("S2b_lockup_horizontal.json");
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
