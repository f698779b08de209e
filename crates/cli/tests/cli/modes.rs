//! `modes`: natural frequencies, critical speeds and the response to a rotating force.

use std::{fs, path::Path};

use wholestring::operation::OperationKind;
use wholestring_results::{
    CAMPBELL, CRITICAL_SPEEDS, MODE_SHAPES, MODES, ModesSummary, RESPONSE, STABILITY, Table,
};

use crate::desk::{Desk, transcript};

/// Three modes of each family, orders 1 and 4, in the slant well.
const FEW: [&str; 6] =
    ["modes", "slant.toml", "--set", "modes.count=3", "--set", "modes.orders=[1, 4]"];

fn few<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&FEW, more].concat()
}

/// Terminal, folder, tables and page agree.
#[test]
fn modes_of_a_slant_well() {
    let desk = Desk::new();
    let output = desk.done(&few(&["-o", "out", "--operation", "rotate_off_bottom"]));
    let stdout = String::from_utf8(output.stdout).unwrap();
    let summary = ModesSummary::read(&desk.path("out/summary.json")).unwrap();
    assert!(summary.stable);
    assert_eq!(summary.operation, OperationKind::RotateOffBottom);
    assert_eq!(summary.settings["modes"]["orders"], serde_json::json!([1.0, 4.0]));
    let count = |family: &str| summary.modes.iter().filter(|mode| mode.family == family).count();
    assert_eq!([count("lateral"), count("axial"), count("torsional")], [3; 3]);
    for mode in &summary.modes {
        assert!(stdout.contains(&format!("{:.4}", mode.frequency_Hz)), "{stdout}");
        assert!((mode.energy.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    }
    assert!(!summary.critical_speeds.is_empty());
    for critical in &summary.critical_speeds {
        let met = critical.order * critical.rotary_speed_rad_per_s / std::f64::consts::TAU;
        assert!((met / critical.frequency_Hz - 1.0).abs() < 1e-6, "{critical:?}");
    }
    for (name, columns) in [
        ("modes", MODES),
        ("mode_shapes", MODE_SHAPES),
        ("campbell", CAMPBELL),
        ("critical_speeds", CRITICAL_SPEEDS),
        ("response", RESPONSE),
    ] {
        let table = Table::read_parquet(&desk.path(&format!("out/{name}.parquet"))).unwrap();
        assert!(table.is_like(&Table::with_columns(columns)), "{name}");
        assert!(table.rows() > 0, "{name}");
    }
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("Campbell diagram") && page.contains("Critical speeds"));

    // The page is rebuilt from the files.
    fs::remove_file(desk.path("out/report.html")).unwrap();
    desk.done(&["report", "out"]);
    assert_eq!(fs::read_to_string(desk.path("out/report.html")).unwrap(), page);
    desk.done(&["plot", "out", "--units", "field"]);
    for name in ["campbell", "mode_shapes", "string_shapes", "response"] {
        assert!(desk.path(&format!("out/plots/{name}.svg")).is_file(), "{name}");
        assert!(desk.path(&format!("out/{name}.csv")).is_file(), "{name}");
    }
}

/// The map is of the operation that drills, whichever is requested; terminal, tables and page
/// agree.
#[test]
fn a_map_of_torsional_stability() {
    let desk = Desk::new();
    let drills = "operation.kind=[\"trip_out\", \"drill\"]";
    let heaviest = ["--set", "modes.heaviest=120 kN", "--set", "modes.highest_frequency=3"];
    // Without friction that decreases with speed there would be no such map.
    let falls = ["--set", "modes.static_over_kinetic=1.2"];
    let arguments = [&["--set", drills, "-o", "out"], &heaviest[..], &falls].concat();
    let output = desk.done(&few(&arguments));
    let stdout = String::from_utf8(output.stdout).unwrap();
    let summary = ModesSummary::read(&desk.path("out/summary.json")).unwrap();
    assert_eq!(summary.no_torsional_stability, None);
    let stability = summary.torsional_stability.expect("a string that drills");
    assert_eq!(stability.highest_frequency_Hz, 3.0);
    assert!(stability.complete);
    assert!(stdout.contains("steady rotation is "), "{stdout}");
    // The analysed operation does not rotate on bottom.
    assert!(stdout.contains("`trip out` does not rotate on bottom, and the case's `drill` at"));
    let table = Table::read_parquet(&desk.path("out/stability.parquet")).unwrap();
    assert!(table.is_like(&Table::with_columns(STABILITY)));
    assert_eq!(table.rows(), 20 * 19);
    let weights = table.numbers("weight_on_bit_N").unwrap();
    assert_eq!(weights.last(), Some(&Some(120e3)));
    assert!(desk.path("out/stability.svg").is_file());
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("Torsional stability"));

    desk.done(&few(&["-o", "out", "--overwrite", "--quiet"]));
    let summary = ModesSummary::read(&desk.path("out/summary.json")).unwrap();
    assert!(summary.no_torsional_stability.is_some(), "nothing drills");
    assert!(!desk.path("out/stability.parquet").exists());

    let output = desk.run(&few(&["--set", "modes.lightest=2000 kN"]));
    assert_eq!(output.status.code(), Some(2));
    assert!(transcript(&output).contains("the map of [modes] has no weights on bit"));
}

/// A map of the vertical case up to a weight, and the output on the terminal.
fn of_vertical(more: &[&str]) -> (ModesSummary, String) {
    let desk = Desk::new();
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/vertical.toml");
    let case = case.to_str().unwrap().to_owned();
    let few = ["--set", "modes.count=2", "--set", "operation.kind=drill", "--overwrite"];
    let output = desk.done(&[&["modes", &case, "-o", "out"], &few[..], more].concat());
    let summary = ModesSummary::read(&desk.path("out/summary.json")).unwrap();
    (summary, String::from_utf8(output.stdout).unwrap())
}

/// If neither the bit's torque nor the friction decreases with speed, a map on which every point is
/// stable is no result: the reason names the missing input of the case, and a usual ratio.
#[test]
fn no_map_where_nothing_falls_with_speed() {
    let light = ["--set", "modes.heaviest=80 kN"];
    let (summary, _) = of_vertical(&light);
    assert!(summary.torsional_stability.is_none());
    let reason = summary.no_torsional_stability.unwrap();
    for part in ["falls with speed", "static", "`heaviest`", "modes.static_over_kinetic = 1.2"] {
        assert!(reason.contains(part), "{reason}");
    }
    let falls = ["--set", "modes.static_over_kinetic=1.2"];
    let (summary, _) = of_vertical(&[light, falls].concat());
    let stability = summary.torsional_stability.expect("a map");
    assert!(!stability.driven_by_rate);
}

/// Under more weight the same case has unstable speeds: its bit drills less at lower speed, which
/// adds weight and torque. The map names that cause.
#[test]
fn a_map_that_the_rate_of_penetration_drives_says_so() {
    let (summary, stdout) = of_vertical(&[]);
    let stability = summary.torsional_stability.expect("a map");
    assert!(stability.driven_by_rate, "{stability:?}");
    assert!(stdout.contains("is driven by the rate of penetration"), "{stdout}");
    assert!(!stdout.contains("does not rotate on bottom"), "{stdout}");
    // A bit whose torque does not depend on its weight has no such cause, and therefore no map.
    let (summary, _) = of_vertical(&["--set", "bit.torque=1 N.m"]);
    assert!(summary.torsional_stability.is_none());
}

/// Eccentric collars excite without any other source.
#[test]
fn what_is_eccentric_is_what_pushes() {
    let desk = Desk::new();
    let eccentric = ["--set", "string.0.eccentricity=2 mm", "-o", "out", "--quiet"];
    let output = desk.done(&few(&eccentric));
    assert!(output.stdout.is_empty());
    let summary = ModesSummary::read(&desk.path("out/summary.json")).unwrap();
    assert_eq!(summary.forcing, "imbalance of the eccentric components");
}

/// Invalid input is reported.
#[test]
fn an_operation_that_the_case_lacks() {
    let desk = Desk::new();
    for (operation, reason) in [
        ("fly", "`fly` is no operation: expected one of "),
        ("ream", "the case has no operation `ream`: it has "),
    ] {
        let output = desk.run(&few(&["--operation", operation]));
        assert_eq!(output.status.code(), Some(2));
        assert!(transcript(&output).contains(reason), "{}", transcript(&output));
    }
    let output =
        desk.run(&few(&["--set", "modes.fastest=10 rpm", "--set", "modes.slowest=20 rpm"]));
    assert_eq!(output.status.code(), Some(2));
    assert!(transcript(&output).contains("the diagram of [modes] has no speeds"));
}

/// Where the string has no answer, the sentence is that of the other commands, in the units of the
/// case.
#[test]
fn no_answer_is_said_as_elsewhere() {
    let desk = Desk::new();
    for (units, symbol) in [("si", " m, "), ("field", " ft, ")] {
        let locked = [
            "--set",
            "operation.kind=slide",
            "--set",
            "operation.wob=2 MN",
            "--set",
            &format!("units={units}"),
        ];
        let own = desk.run(&few(&[&["-o", units], &locked[..]].concat()));
        assert_eq!(own.status.code(), Some(3), "{}", transcript(&own));
        let own = String::from_utf8(own.stderr).unwrap();
        let (_, own) = own.split_once("error: slide: the string has no answer: ").expect(&own);
        assert!(own.starts_with("Locks up:") && own.contains(symbol), "{own}");
        let folder = format!("{units}-run");
        let run = ["run", "slant.toml", "-o", &folder, "--set", "model=stiff"];
        let run = desk.run(&[&run[..], &locked].concat());
        let run = String::from_utf8(run.stderr).unwrap();
        let (_, run) = run.split_once("has no answer: ").expect(&run);
        assert_eq!(own.lines().next(), run.lines().next());
    }
}

/// A slim bent motor in a lateral. Tripping out without rotation it would turn away from its tool
/// face: a warning says that this motion has no frequency, and the numbers of the others begin
/// after it. Rotating it has the torsional modes of a straight string.
#[test]
fn an_unstable_tool_face_has_a_warning_and_no_frequency() {
    let desk = Desk::new();
    fs::write(desk.path("lateral.toml"), LATERAL).unwrap();
    let modes = |more: &[&str]| {
        let few = ["modes", "lateral.toml", "--set", "modes.count=2", "-o", "out", "--overwrite"];
        let output = desk.done(&[&few[..], more].concat());
        let summary = ModesSummary::read(&desk.path("out/summary.json")).unwrap();
        let stdout = String::from_utf8(output.stdout).unwrap();
        let shown = stdout + &String::from_utf8(output.stderr).unwrap();
        assert!(!shown.contains(" inf ") && !shown.contains(" 0.0000 "), "{shown}");
        assert!(summary.modes.iter().all(|mode| mode.frequency_Hz > 0.0));
        let torsional = summary.modes.iter().filter(|mode| mode.family == "torsional");
        (torsional.map(|mode| mode.frequency_Hz).collect::<Vec<_>>(), summary.checks, shown)
    };
    let (straight, ..) = modes(&["--operation", "trip_out", "--set", "string.1.bend=0deg"]);
    let (tripping, checks, shown) = modes(&["--operation", "trip_out"]);
    assert!(straight[0] < tripping[0] && tripping[0] < straight[1], "{tripping:?}");
    let sentence = &checks.first().expect("a check").sentence;
    assert!(sentence.starts_with("The tool face is not stable"), "{sentence}");
    assert!(shown.contains(&format!("warning: {sentence}")), "{shown}");
    assert!(shown.contains("Unstable modes have no frequency"), "{shown}");
    let page = fs::read_to_string(desk.path("out/report.html")).unwrap();
    assert!(page.contains("The tool face is not stable"));
    let (rotating, checks, _) = modes(&["--operation", "rotate_off_bottom"]);
    assert!(checks.is_empty(), "{checks:?}");
    for (rotating, straight) in rotating.iter().zip(&straight) {
        assert!((rotating / straight - 1.0).abs() < 2e-4, "{rotating} for {straight}");
    }
}

const LATERAL: &str = r#"
[well]
stations = [[0, 0, 180], [1800, 0, 180], [2100, 90, 180], [5100, 90, 180]]
hole = [{ kind = "open", to = "5100 m", diameter = "155.575 mm", friction = 0.3 }]

[mud]
density = "1.15 sg"

[[string]]
component = "bit"
od = "155.575 mm"
length = "0.25 m"

[[string]]
component = "motor"
od = "4-3/4 in"
id = "2-1/4 in"
length = "8 m"
bend = "1.5 deg"
bend_at = "1.5 m"

[[string]]
component = "MWD"
od = "4-3/4 in"
id = "2-1/4 in"
length = "18 m"

[[string]]
component = "drill pipe"
catalogue = "4 in 14.00 lb/ft S-135"
length = "to surface"

[operation]
kind = ["trip_out", "rotate_off_bottom"]
rpm = 60
"#;
