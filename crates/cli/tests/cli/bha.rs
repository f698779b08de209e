//! `bha`: static BHA analysis.

use std::{collections::BTreeSet, fs, path::Path};

use wholestring::operation::OperationKind;
use wholestring_results::{BhaSummary, BhaVaried};

use crate::desk::{Desk, transcript};

fn case() -> String {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    cases.join("bent-motor.toml").to_str().expect("a name").to_owned()
}

fn summary(desk: &Desk, folder: &str) -> BhaSummary {
    BhaSummary::read(&desk.path(folder).join("summary.json")).unwrap()
}

/// Screen, summary, tables, page and pictures of one assembly agree.
#[test]
fn an_assembly_at_rest() {
    let desk = Desk::new();
    let case = case();
    let arguments = [
        "bha",
        &case,
        "-o",
        "results",
        "--csv",
        "--toolface",
        "0deg..270deg/90deg",
        "--weight",
        "40kN,80kN",
        "--inclination",
        "20deg..60deg/20deg",
    ];
    let output = desk.done(&arguments);
    let screen = transcript(&output);
    for part in [
        "Bent motor: static BHA analysis, slide, bit at 1500 m, inclination 40 deg",
        "side force, kN",
        "bearing housing",
        "Sag at 13.7 m in MWD: inclination -0.",
        "Largest bending moment",
        "Other tool faces",
        "It builds at every inclination",
        "Mean of all tool faces",
        // Depths to the centimetre at any depth.
        "1490.95",
    ] {
        assert!(screen.contains(part), "{part}: {screen}");
    }
    let summary = summary(&desk, "results");
    assert_eq!((summary.case.as_str(), summary.operation), ("Bent motor", OperationKind::Slide));
    let state = &summary.state;
    assert!(state.stable && state.residual < 1e-8);
    // It presses towards 30° from the high side, the direction of its bend.
    let [high_N, right_N] = state.side_force_N;
    let angle = right_N.atan2(high_N).to_degrees();
    assert!((20.0..40.0).contains(&angle) && high_N > 10e3, "{high_N} {right_N}");
    let errors = state.errors.expect("an estimate");
    assert!(errors.side_force_N < 0.02 * high_N, "{errors:?}");
    assert!(state.length_m > 140.0 && state.solved_m > state.length_m + 90.0);
    let [sag] = &state.sag[..] else { panic!("one sensor: {:?}", state.sag) };
    assert!((sag.from_bit_m - 13.7).abs() < 1e-9 && sag.inclination_rad < 0.0);
    // Contents of the tables.
    let contacts = desk.table("results/bha_contacts.parquet");
    assert_eq!(contacts.rows(), state.contacts.len());
    assert_eq!(contacts.words("touching").expect("words")[0], "bit");
    let nodes = desk.table("results/bha.parquet");
    let moments = nodes.numbers("bending_moment_N_m").expect("numbers");
    let largest = moments.iter().flatten().fold(0.0_f64, |most, flatten| most.max(*flatten));
    assert!(largest >= state.largest_bending_moment_N_m.value);
    assert!(desk.path("results/bha_sweep.csv").is_file());
    let varied = |varied_input: BhaVaried| {
        summary.sweep.iter().filter(move |point| point.varied == varied_input)
    };
    assert_eq!(varied(BhaVaried::Toolface).count(), 4);
    assert_eq!(varied(BhaVaried::Weight).count(), 2);
    assert_eq!(varied(BhaVaried::Inclination).count(), 3);
    assert!(summary.sweep.iter().all(|point| point.found.is_some()));
    let mean = summary.mean_side_force_N.expect("a revolution");
    assert!(mean[0].abs() < 0.1 * high_N, "{mean:?}");
    // The page and the pictures are rebuilt from the files.
    let page = || fs::read(desk.path("results/report.html")).unwrap();
    let before = page();
    desk.done(&["report", "results"]);
    assert!(page() == before);
    desk.done(&["plot", "results", "-o", "pictures"]);
    let pictures: BTreeSet<String> = fs::read_dir(desk.path("pictures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_str().unwrap().to_owned())
        .collect();
    let named = ["bending.svg", "inclination.svg", "toolface.svg", "views.svg", "weight.svg"];
    assert_eq!(pictures, named.map(String::from).into());
}

/// Other operations, the whole string, a hole that builds, a case without a sensor or a bend.
#[test]
fn other_ways() {
    let desk = Desk::new();
    let case = case();
    let few = ["--inclination", "40deg", "--toolface", "0deg", "--weight", "50kN"];
    let run = |more: &[&str], folder: &str| {
        let arguments = [&["bha", &case, "-q", "-o", folder], &few[..], more].concat();
        let output = desk.done(&arguments);
        assert!(output.stdout.is_empty(), "{}", transcript(&output));
        summary(&desk, folder)
    };
    let slide = run(&[], "slide");
    let whole = run(&["--whole"], "whole");
    let force_N = |summary: &BhaSummary| summary.state.side_force_N[0];
    assert!((force_N(&whole) / force_N(&slide) - 1.0).abs() < 1e-3);
    assert!((whole.state.solved_m - 1500.0).abs() < 1e-6);
    let drill = run(&["--operation", "drill"], "drill");
    assert_eq!(drill.operation, OperationKind::Drill);
    let builds = run(&["--build", "4deg/30m"], "builds");
    let drops = run(&["--build", "-4deg/30m"], "drops");
    let straight = |summary: &BhaSummary| {
        let mut points = summary.sweep.iter().filter(|one| one.varied == BhaVaried::Inclination);
        points.next().and_then(|one| one.found).expect("a point").side_force_N[0]
    };
    assert!(straight(&builds) < straight(&slide) && straight(&slide) < straight(&drops));
    let output = desk.done(&["bha", "slant.toml", "-o", "slant"]);
    let screen = transcript(&output);
    assert!(screen.contains("no component has a survey_sensor"), "{screen}");
    let slant = summary(&desk, "slant");
    assert!(slant.toolface_rad.is_none() && slant.mean_side_force_N.is_none());
}

#[test]
fn mistakes() {
    let desk = Desk::new();
    let case = case();
    for (arguments, status, message) in [
        (
            &["bha", &case, "--operation", "ream"][..],
            2,
            "the case has no ream: it has slide, drill",
        ),
        (&["bha", &case, "--operation", "reem"], 2, "`reem` is no operation"),
        (&["bha", "slant.toml", "--toolface", "90deg"], 2, "no component of the string has a bend"),
        (&["bha", &case, "--toolface", "0deg..90deg"], 2, "a range needs a step"),
        (&["bha", &case, "--weight", "10m"], 2, "`10m` is no force"),
        (&["bha", &case, "--inclination", "200deg"], 2, "outside 0 to 180 deg"),
        (&["bha", &case, "--build", "1e9deg/30m"], 2, "outside -180 deg/30m to 180 deg/30m"),
        (&["bha", &case, "--build", "-200deg/30m"], 2, "outside -180 deg/30m to 180 deg/30m"),
        (&["bha", &case, "--build", "1e999deg/30m"], 2, "too large for a dogleg severity"),
        (&["bha", &case, "--weight", "6MN"], 2, "outside 0 to 5000 kN"),
        (&["bha", &case, "--weight", "6MN", "--units", "field"], 2, "outside 0 to 1124 klbf"),
        (&["bha", &case, "--set", "string.4.survey_sensor=9.5m"], 2, "not on its component"),
    ] {
        let output = desk.run(arguments);
        let text = transcript(&output);
        assert_eq!(output.status.code(), Some(status), "{text}");
        assert!(text.contains(message), "{arguments:?}: {text}");
    }
    let two = desk.done(&["bha", &case, "-q", "-o", "a", "--inclination", "40deg"]);
    assert!(two.stderr.is_empty());
    let output = desk.run(&["plot", "a", "a"]);
    assert!(transcript(&output).contains("cannot be overlaid"), "{}", transcript(&output));
}

/// Limits without a capacity in the case are listed on the terminal as not checked.
#[test]
fn what_was_not_checked_is_listed() {
    let desk = Desk::new();
    let output = desk.done(&["bha", "slant.toml", "-o", "out"]);
    let screen = transcript(&output);
    let summary = summary(&desk, "out");
    let phrases = wholestring_results::Unchecked::phrases(&summary.unchecked);
    assert!(!phrases.is_empty(), "pipe without a yield strength: {summary:?}");
    for phrase in phrases {
        assert!(screen.contains(&format!("not checked: {phrase}\n")), "{phrase}: {screen}");
    }
    let output = desk.done(&[
        "bha",
        "slant.toml",
        "-o",
        "given",
        "--set",
        "string.0.yield_strength=900 MPa",
    ]);
    assert!(!transcript(&output).contains("not checked: von Mises"), "{}", transcript(&output));
}

/// An assembly whose string above does not slide down has the verdict that `run` has: the
/// equilibrium of its lower end says nothing of that.
#[test]
fn an_assembly_that_its_string_does_not_carry_down() {
    let desk = Desk::new();
    let case = case().replace("bent-motor", "lateral-that-cannot-be-drilled");
    let options = ["--set", "model=soft", "--set", "operation.kind=slide", "--strict"];
    let found = desk.run(&[&["bha", &case, "-o", "bha"][..], &options].concat());
    assert_eq!(found.status.code(), Some(4), "{}", transcript(&found));
    let run = desk.run(&[&["run", &case, "-o", "run"][..], &options].concat());
    assert_eq!(run.status.code(), Some(4), "{}", transcript(&run));
    let checks = |folder: &str| -> BTreeSet<String> {
        let text = fs::read(desk.path(folder).join("summary.json")).expect("a summary");
        let summary: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
        let state = summary["operations"].get(0).unwrap_or(&summary);
        let checks = state["checks"].as_array().expect("checks");
        let descent = checks.iter().filter(|check| {
            ["lock_up", "goes_down"].contains(&check["kind"].as_str().unwrap_or_default())
        });
        descent.map(ToString::to_string).collect()
    };
    let screen = transcript(&found);
    assert!(screen.contains("error: Lock-up"), "{screen}");
    let page = fs::read_to_string(desk.path("bha/report.html")).expect("a page");
    assert!(page.contains("lock_up"));
    assert_eq!(checks("bha").len(), 2);
    assert_eq!(checks("bha"), checks("run"));
}
