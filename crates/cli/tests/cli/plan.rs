//! `plan`: broomsticks, buckling weights and limits at every bit depth.

use std::{fs, path::Path};

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_results::{
    CheckKind, PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_FRICTION, PLAN_LIMITS, PLAN_MEASURED,
    PLAN_OVERLAY, PLAN_SURFACE_LIMITS, PlanOperation, PlanSummary, Table, UNCERTAIN,
    UNCERTAIN_INDICES, UNCERTAIN_SAMPLES,
};

use crate::desk::{Desk, transcript};

/// Four depths of the slant well.
const FEW: [&str; 6] = [
    "plan",
    "slant.toml",
    "--set",
    "plan.depths=4",
    "--set",
    "operation.kind=[\"trip_out\", \"drill\"]",
];

fn few<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&FEW, more].concat()
}

/// The same for the shipped slant well, whose pipe is from the catalogue.
fn few_of_well<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["plan", "well.toml"], &FEW[2..], more].concat()
}

/// Terminal, summary, tables, page and workbook agree, and the page is rebuilt from the files.
#[test]
fn a_plan_of_a_slant_well() {
    let desk = Desk::new();
    let output = desk.done(&few(&["-o", "out"]));
    let stdout = String::from_utf8(output.stdout).unwrap();
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    use OperationKind::{Drill, RotateOffBottom, TripIn, TripOut};
    assert_eq!(summary.operations, [TripOut, TripIn, RotateOffBottom, Drill]);
    assert_eq!(summary.models, [ModelKind::Soft]);
    let depths = summary.bit_depths_m.len();
    assert!(depths >= 4);
    assert_eq!(summary.points.len(), depths * 4 * 3);
    assert_eq!(summary.buckling.len(), depths * 2 * 3);
    assert_eq!(summary.missing, 0);
    for operation in summary.operations.iter().copied() {
        for level in FrictionLevel::ALL {
            let last = summary.curve(ModelKind::Soft, operation, level).last().expect("points");
            let hook_kN = 1e-3 * last.scalars.expect("an answer").hook_load_N;
            assert!(stdout.contains(&format!("{hook_kN:.1}")), "{stdout}");
        }
    }
    for (name, columns) in [
        ("plan_broomstick", PLAN_BROOMSTICK),
        ("plan_buckling", PLAN_BUCKLING),
        ("plan_friction", PLAN_FRICTION),
        ("plan_limits", PLAN_LIMITS),
    ] {
        let table = Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap();
        assert!(table.is_like(&Table::with_columns(columns)), "{name}");
        assert!(table.rows() > 0 && desk.path(&format!("out/{name}.csv")).is_file(), "{name}");
    }
    for name in ["hook_load", "torque", "buckling_weight"] {
        for ending in ["svg", "csv"] {
            assert!(desk.path(&format!("out/{name}.{ending}")).is_file(), "{name}.{ending}");
        }
    }
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    for expected in ["Hook load", "Weight to buckle", "Nearest limits", "trip out"] {
        assert!(page.contains(expected), "{expected}");
    }
    let workbook = fs::read(desk.path("out/plan.xlsx")).unwrap();
    assert!(workbook.starts_with(b"PK"));
    assert!(!desk.path("out/checkpoint.bin").exists());

    for name in ["report.html", "plan.xlsx"] {
        fs::remove_file(desk.path(&format!("out/{name}"))).unwrap();
    }
    desk.done(&["report", "out"]);
    assert_eq!(fs::read_to_string(desk.path("out/report.html")).unwrap(), page);
    assert!(desk.path("out/plan.xlsx").is_file());
    desk.done(&["plot", "out", "--units", "field"]);
    assert!(desk.path("out/plots/hook_load.svg").is_file());
}

/// Every limit of hook load and torque at the surface is in the summary, in its table, a line on
/// the picture and a column of its numbers.
#[test]
fn limits_stand_on_the_broomstick() {
    let desk = desk_with("");
    let rig = [
        "rig.block_weight=100 kN",
        "rig.hoist_capacity=600 kN",
        "rig.top_drive_torque=5 kN.m",
        "rig.top_drive_peak_torque=6 kN.m",
        "rig.pump_pressure_limit=30 MPa",
        "mud.density=1200 kg/m3",
        "mud.rheology=bingham",
        "mud.plastic_viscosity=0.02 Pa.s",
        "mud.yield_point=7 Pa",
        "operation.flow_rate=30 l/s",
        "operation.wob=50 kN",
    ];
    let rig: Vec<&str> = rig.iter().flat_map(|rig| ["--set", rig]).collect();
    desk.done(&few_of_well(&[&["-o", "out", "--quiet"][..], &rig].concat()));
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    let limits = &summary.surface_limits;
    let hoist = limits.iter().find(|limit| limit.kind == "hoist").unwrap();
    assert!((hoist.allowed - (0.9 * 600e3 - 100e3)).abs() < 1e-6, "{hoist:?}");
    let of_torque = limits.iter().filter(|limit| limit.is_torque);
    let kinds: Vec<&str> = of_torque.map(|of_torque| of_torque.kind.as_str()).collect();
    assert_eq!(kinds, ["top_drive", "top_drive_peak", "make_up", "torsion"]);
    let table = desk.table("out/plan_surface_limits.parquet");
    assert!(table.is_like(&Table::with_columns(PLAN_SURFACE_LIMITS)));
    assert_eq!(table.rows(), 2 * limits.len());
    let csv = |name: &str| Table::read_csv(&desk.path(&format!("out/{name}.csv"))).unwrap();
    let (hook_load, torque) = (csv("hook_load"), csv("torque"));
    let line = |table: &Table, name: &str, value: f64| {
        let column = table.words(name).unwrap_or_else(|| panic!("{name}"));
        assert!(!column.is_empty(), "{name}");
        assert!(column.iter().all(|cell| cell.parse() == Ok(value)), "{name}: {column:?}");
    };
    for limit in limits {
        let (table, name) = match limit.is_torque {
            true => (&torque, format!("{}_limit_surface_torque_N_m", limit.kind)),
            false => (&hook_load, format!("{}_limit_hook_load_N", limit.kind)),
        };
        line(table, &name, limit.allowed);
    }
    // The same holds for the static mud pressure, the pump's limit and the case's weight on bit.
    let mud = csv("hydraulics");
    line(&mud, "mud_density_kg_per_m3", 1200.0);
    line(&mud, "pump_limit_standpipe_pressure_Pa", 30e6);
    line(&csv("buckling_weight"), "case_weight_on_bit_N", 50e3);
    let picture = desk.text("out/torque.svg");
    assert!(picture.contains(">top drive<") && picture.contains(">top drive, peak<"));
}

/// For each operation, the one limit that breaks or stops with the smallest margin of all rows: on
/// the screen, on the page and in the summary. The margin to buckling, which breaks nothing, is
/// smaller.
#[test]
fn the_governing_limit_of_each_operation_is_given() {
    let desk = desk_with("");
    let rig = ["--set", "rig.top_drive_torque=5 kN.m", "--set", "operation.wob=100 kN"];
    let output = desk.done(&few_of_well(&[&["-o", "out"][..], &rig].concat()));
    let stdout = String::from_utf8(output.stdout).unwrap();
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    let operations: Vec<&str> =
        summary.governing.iter().map(|governing| governing.operation.name()).collect();
    let mut all: Vec<&str> = summary.operations.iter().map(|operation| operation.name()).collect();
    all.sort_unstable();
    let mut sorted = operations.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, all);
    let limits = desk.table("out/plan_limits.parquet");
    let words = |name: &str| limits.words(name).unwrap();
    let numbers = |name: &str| limits.numbers(name).unwrap();
    let bends = ["sinusoidal_buckling", "helical_buckling", "overpull", "side_force"];
    for first in &summary.governing {
        let rows =
            (0..limits.rows()).filter(|row| words("operation")[*row] == first.operation.name());
        let (mut least, mut least_of_all) = (f64::INFINITY, f64::INFINITY);
        for row in rows {
            let reserve = numbers("factor")[row].unwrap() / numbers("required")[row].unwrap();
            least_of_all = least_of_all.min(reserve);
            if !bends.contains(&words("kind")[row].as_str()) {
                least = least.min(reserve);
            }
        }
        assert_eq!(first.check.reserve(), least, "{first:?}");
        if first.operation == PlanOperation::Kind(OperationKind::Drill) {
            assert_eq!(
                (first.check.kind, first.friction),
                (CheckKind::TopDrive, FrictionLevel::High)
            );
            assert!(least_of_all < least, "{first:?}");
        }
    }
    let drilling = "drill, high friction, bit at ";
    assert!(stdout.contains(drilling), "{stdout}");
    assert!(desk.text("out/report.html").contains(", governs"));
    let pick_up = summary
        .governing
        .iter()
        .find(|governing| governing.operation == PlanOperation::Kind(OperationKind::TripOut))
        .unwrap();
    let place = format!("of {} at ", pick_up.check.component.as_deref().unwrap());
    let sentence = stdout.lines().find(|line| line.trim_start().starts_with("trip out, ")).unwrap();
    assert!(sentence.contains(&place), "{sentence}");
}

/// Above the depth from which the campaign drills nothing is drilled: the plan gives no verdict of
/// drilling there, although the points are solved.
#[test]
fn no_verdicts_of_depths_that_are_not_drilled() {
    let desk = desk_with("");
    let shallowest_m = |folder: &str, from: &str| -> f64 {
        let from = format!("plan.campaign.drilled_from={from}");
        let more = [
            "--set",
            // A weight under which the shortest string is a helix.
            "operation.wob=160 kN",
            "--set",
            "plan.bit_depths=[\"400 m\", \"600 m\", \"800 m\", \"1200 m\"]",
        ];
        desk.done(&few_of_well(&[&["-o", folder, "--set", &from][..], &more].concat()));
        let summary = PlanSummary::read(&desk.path(folder).join("summary.json")).unwrap();
        let mut points = summary.points.iter();
        let is_shallow = |point: &wholestring_results::PlanPoint| point.bit_depth_m < 500.0;
        assert!(points.any(|point| point.operation == OperationKind::Drill && is_shallow(point)));
        let drills = PlanOperation::Kind(OperationKind::Drill);
        let checks = summary.checks.iter().chain(&summary.governing);
        let own = checks.filter(|row| row.operation == drills);
        own.map(|row| row.bit_depth_m).fold(f64::INFINITY, f64::min)
    };
    let drilled_m = shallowest_m("deep", "700 m");
    assert!(drilled_m > 699.0 && drilled_m < 1300.0, "{drilled_m}");
    let drilled_m = shallowest_m("all", "100 m");
    assert!(drilled_m < 500.0, "{drilled_m}");
}

/// One thread and four give the same results.
#[test]
fn a_plan_does_not_depend_on_threads() {
    let desk = Desk::new();
    desk.done(&few(&["-o", "one", "--jobs", "1", "--quiet"]));
    desk.done(&few(&["-o", "four", "--jobs", "4", "--quiet"]));
    for name in ["summary.json", "plan_broomstick.csv", "plan_buckling.csv", "plan_limits.csv"] {
        let read = |folder: &str| fs::read(desk.path(&format!("{folder}/{name}"))).unwrap();
        assert!(read("one") == read("four"), "{name}");
    }
}

/// A string that locks up gives a row with a reason and does not fail the plan.
#[test]
fn what_has_no_answer_says_why() {
    let desk = Desk::new();
    desk.done(&[
        "plan",
        "slant.toml",
        "--set",
        "operation.kind=[\"slide\"]",
        "--set",
        "operation.wob=3 MN",
        "--set",
        "plan.operations=[\"trip_in\", \"slide\"]",
        "--set",
        "plan.depths=3",
        "--set",
        "buckling.helix_side_force=counted",
        "-o",
        "out",
    ]);
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    for point in &summary.points {
        assert_eq!(point.scalars.is_none(), point.message.is_some());
    }
    assert_eq!(summary.points.len(), summary.bit_depths_m.len() * 2 * 3);
    let locks_up = |point: &&wholestring_results::PlanPoint| {
        point.message.as_ref().is_some_and(|why| why.starts_with("Locks up"))
    };
    assert!(
        summary
            .points
            .iter()
            .any(|point| point.operation == OperationKind::Slide && locks_up(&point))
    );
    assert!(
        !summary
            .points
            .iter()
            .any(|point| point.operation == OperationKind::TripIn && locks_up(&point))
    );
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("Without an answer"));
}

/// Another case's results stay unchanged, and impossible requests are reported.
#[test]
fn bad_input_gets_an_answer() {
    let desk = Desk::new();
    desk.done(&few(&["-o", "out", "--quiet"]));
    let output = desk.run(&few(&["-o", "out", "--set", "plan.depths=5"]));
    assert_eq!(output.status.code(), Some(2));
    assert!(transcript(&output).contains("--overwrite"), "{}", transcript(&output));
    let output = desk.run(&few(&["--set", "plan.friction.low=0.9"]));
    assert_eq!(output.status.code(), Some(2));
    assert!(transcript(&output).contains("low friction is more than expected friction"));
}

/// Bands of uncertain inputs on the screen, the page and in the workbook's tables; the page is
/// rebuilt.
#[test]
fn a_plan_of_uncertain_numbers() {
    let desk = Desk::new();
    let uncertain = "plan.uncertain.input=[{ key = \"mud.density\", from = \"1.1 sg\", to = \"1.3 sg\" }, \
        { key = \"friction\", mean = 0.25, std = 0.03, from = 0.1 }]";
    let more = ["--set", uncertain, "--set", "plan.uncertain.samples=40"];
    let output = desk.done(&few(&[&more[..], &["-o", "out"]].concat()));
    let stdout = String::from_utf8(output.stdout).unwrap();
    assert!(
        stdout.contains("Bands: 5 to 95 % of 40 samples of 2 uncertain numbers, soft"),
        "{stdout}"
    );
    assert!(
        stdout.contains("trip out: hook load ") && stdout.contains("% due to friction"),
        "{stdout}"
    );
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    let found = summary.uncertain.expect("bands");
    assert_eq!((found.samples, found.solved, found.lacking), (40, 40, 0));
    let tables = [
        ("plan_uncertain", UNCERTAIN),
        ("plan_uncertain_indices", UNCERTAIN_INDICES),
        ("plan_uncertain_samples", UNCERTAIN_SAMPLES),
    ];
    for (name, columns) in tables {
        let table = Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap();
        assert!(table.is_like(&Table::with_columns(columns)), "{name}");
        assert!(table.rows() > 0 && desk.path(&format!("out/{name}.csv")).is_file(), "{name}");
    }
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    for expected in ["Uncertain inputs", "Bands", "Sensitivity", "Sobol indices"] {
        assert!(page.contains(expected), "{expected}");
    }
    for name in ["report.html", "plan.xlsx"] {
        fs::remove_file(desk.path(&format!("out/{name}"))).unwrap();
    }
    desk.done(&["report", "out"]);
    assert_eq!(fs::read_to_string(desk.path("out/report.html")).unwrap(), page);
    assert!(fs::read(desk.path("out/plan.xlsx")).unwrap().starts_with(b"PK"));
}

/// Another program's curves: a plan's own curves differ from it by nothing; scaled ones by their
/// scale.
#[test]
fn another_program_is_laid_over_the_plan() {
    let desk = desk_with("");
    desk.done(&[&WELL[..], &["-o", "own"]].concat());
    let own = PlanSummary::read(&desk.path("own/summary.json")).unwrap();
    let mut theirs = String::from("Bit depth (m),Pick-up (kN),Slack-off (kN),Torque (kN.m)\n");
    let depths: Vec<f64> = own.bit_depths_m.clone();
    let scalars = |operation: OperationKind, depth_m: f64| {
        let mut curve = own.curve(ModelKind::Soft, operation, FrictionLevel::Expected);
        curve.find(|curve| curve.bit_depth_m == depth_m).unwrap().scalars.unwrap()
    };
    for &depth_m in &depths {
        let pick_up_kN = scalars(OperationKind::TripOut, depth_m).hook_load_N / 1e3;
        let slack_off_kN = scalars(OperationKind::TripIn, depth_m).hook_load_N / 1e3 + 10.0;
        let torque = scalars(OperationKind::RotateOffBottom, depth_m).surface_torque_N_m / 1e3;
        theirs += &format!("{depth_m},{pick_up_kN},{slack_off_kN},{torque}\n");
    }
    fs::write(desk.path("other.csv"), &theirs).unwrap();
    let with = ["--overlay", "other.csv", "-o", "out"];
    let output = desk.done(&[&WELL[..], &with].concat());
    let stdout = String::from_utf8(output.stdout).unwrap();
    assert!(stdout.contains("other.csv: ours less theirs, trip in hook load"), "{stdout}");
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    let overlay = summary.overlay.as_ref().unwrap();
    assert_eq!(overlay.file, "other.csv");
    let differences = &overlay.differences;
    let means: Vec<(OperationKind, bool, f64)> = differences
        .iter()
        .map(|difference| (difference.operation, difference.is_torque, difference.mean))
        .collect();
    // To the digits of the file.
    let expected = [
        (OperationKind::TripOut, false, 0.0),
        (OperationKind::TripIn, false, -10e3),
        (OperationKind::RotateOffBottom, true, 0.0),
    ];
    assert_eq!(means.len(), expected.len(), "{means:?}");
    for (found, expected_row) in means.iter().zip(expected) {
        assert_eq!((found.0, found.1), (expected_row.0, expected_row.1));
        assert!((found.2 - expected_row.2).abs() < 1e-6, "{found:?}");
    }
    let table = desk.table("out/plan_overlay.parquet");
    assert!(table.is_like(&Table::with_columns(PLAN_OVERLAY)));
    assert_eq!(table.rows(), 3 * depths.len());
    assert!(desk.text("out/hook_load.csv").contains("trip_in_overlay_hook_load_N"));
    let page = desk.text("out/report.html");
    assert!(page.contains("another program: other.csv") && page.contains("plan_overlay.csv"));
    fs::remove_file(desk.path("out/report.html")).unwrap();
    desk.done(&["report", "out"]);
    assert_eq!(desk.text("out/report.html"), page);

    desk.done(&[&WELL[..], &["-o", "out", "--overwrite"]].concat());
    assert!(!desk.path("out/plan_overlay.csv").exists());
    assert!(!desk.text("out/report.html").contains("another program"));
}

/// Invalid curves of another program.
#[test]
fn a_bad_overlay_gets_an_answer() {
    let desk = desk_with("");
    for (name, text, answer) in [
        ("none.csv", None, "there is no such file"),
        ("empty.csv", Some(""), "the file is empty"),
        ("words.csv", Some("to be or not to be\n"), "error:"),
        ("unit.csv", Some("Bit depth (m),Pick-up\n500,300\n"), "has no unit"),
        ("cell.csv", Some("Bit depth (m),Pick-up (kN)\n500,much\n"), "much"),
    ] {
        if let Some(text) = text {
            fs::write(desk.path(name), text).unwrap();
        }
        let output = desk.run(&[&WELL[..], &["-o", "out", "--overlay", name]].concat());
        let stdout = transcript(&output);
        assert_eq!(output.status.code(), Some(2), "{name}: {stdout}");
        let words = stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(answer) && words.contains(name), "{name}: {stdout}");
        // The mistake is reported before anything is solved.
        assert!(!desk.path("out/summary.json").exists(), "{name}");
    }
}

/// Weights and torques of the slant well, equal to the plan with the same friction at a depth, next
/// to rows of another string and held-out rows.
const READ: &str = "Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN),Torque (kN.m),use,\
                    string.1.length (m)\n";

fn desk_with(rows: &str) -> Desk {
    let desk = Desk::new();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    fs::copy(shipped, desk.path("well.toml")).unwrap();
    fs::write(desk.path("read.csv"), format!("{READ}{rows}")).unwrap();
    desk
}

/// Three depths of that well.
const WELL: [&str; 4] =
    ["plan", "well.toml", "--set=plan.depths=3", "--set=rig.block_weight=200 kN"];

fn measured<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&WELL[..], &["--set=plan.measured=read.csv"], more].concat()
}

/// Tables, page, workbook and terminal have the measured values, each row compared with its own
/// string; a plan without measurements has none.
#[test]
fn what_was_measured_is_held_against_the_plan() {
    let desk = desk_with("400,,,,,yes,\n500,330,250,290,1.2,yes,\n500,330,,,,no,20\n");
    let output = desk.done(&measured(&["-o", "out"]));
    let stdout = String::from_utf8(output.stdout).unwrap();
    let noted = String::from_utf8(output.stderr).unwrap();
    assert!(noted.contains("note: read.csv: ") && noted.contains("3 rows"), "{noted}");
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    let rows = &summary.measured;
    let readings: Vec<&str> = rows.iter().map(|row| row.reading.as_str()).collect();
    assert_eq!(readings, ["pick_up", "pick_up", "slack_off", "rotating", "torque"]);
    let (between, all) = summary.measured_between(ModelKind::Soft);
    assert!(stdout.contains(&format!("measured: {between} of {all} readings")), "{stdout}");
    // Friction of rotating off bottom moves no weight.
    assert_eq!((all, rows[3].between()), (4, None));

    // The first row is the plan's own string: the value of the plan at that depth, and the block.
    desk.done(&measured(&["-o", "at", "--set=plan.bit_depths=[\"500 m\"]"]));
    let at = PlanSummary::read(&desk.path("at/summary.json")).unwrap();
    let (first, other) = (&rows[0], &rows[1]);
    for (level, predicted) in FrictionLevel::ALL.into_iter().zip(first.predicted) {
        let hook_load_N = at
            .curve(ModelKind::Soft, OperationKind::TripOut, level)
            .next()
            .unwrap()
            .scalars
            .unwrap()
            .hook_load_N;
        assert_eq!(predicted, Some(hook_load_N + 200e3));
    }
    assert_eq!(first.residual(), Some(330e3 - first.predicted[1].unwrap()));
    // The other row belongs to a string with shorter collars.
    assert!(other.held_out && !first.held_out);
    assert!(other.predicted[1] < first.predicted[1]);

    let table = desk.table("out/plan_measured.parquet");
    assert!(table.is_like(&Table::with_columns(PLAN_MEASURED)));
    assert_eq!(table.rows(), 5);
    assert_eq!(table.numbers("hook_load_N").unwrap()[0], Some(130e3));
    assert!(desk.text("out/plan_measured.csv").starts_with("model,"));
    assert!(desk.text("out/hook_load.csv").contains("trip_out_measured_hook_load_N"));
    let page = desk.text("out/report.html");
    assert!(page.contains("plan_measured.csv") && page.contains("measured, held out"));
    fs::remove_file(desk.path("out/report.html")).unwrap();
    desk.done(&["report", "out"]);
    assert_eq!(desk.text("out/report.html"), page);

    desk.done(&[&WELL[..], &["-o", "out", "--overwrite"]].concat());
    assert!(!desk.path("out/plan_measured.csv").exists());
    assert!(!desk.text("out/report.html").contains("plan_measured"));
}

#[test]
fn bad_measured_weights_get_an_answer() {
    for (rows, expected) in [
        (
            "900,,,,,yes,\n5000,330,,,,yes,\n",
            "line 3: the bit is at 5000.0 m, but hole and survey of its case end",
        ),
        ("3,330,,,,yes,\n", "m long below its drill pipe"),
        ("500,330,,,,yes,20000\n", "line 2: "),
    ] {
        let desk = desk_with(rows);
        let output = desk.run(&measured(&[]));
        assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
        let stdout = transcript(&output).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(stdout.contains("read.csv, ") && stdout.contains(expected), "{stdout}");
        assert!(!desk.path("out").exists());
    }
}
