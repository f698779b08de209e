//! Checks of a result: in the summary, on the screen, in `sweep.csv`, in studies, and as an exit
//! status.

use std::{collections::BTreeSet, fs, path::Path};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{Check, CheckKind, OperationSummary, Severity};

use crate::{
    desk::{Desk, args},
    run::SOFT,
    sweep::split,
};

/// A lateral of 4500 m, whose errors either model must report.
fn lateral() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let case = root.join("lateral-that-cannot-be-drilled.toml");
    case.to_str().unwrap().to_owned()
}

fn kinds(solved: &OperationSummary, severity: Severity) -> BTreeSet<CheckKind> {
    let checks = solved.checks.iter().filter(|check| check.severity == severity);
    checks.map(|check| check.kind).collect()
}

fn found(solved: &OperationSummary, kind: CheckKind) -> &Check {
    let mut all = solved.checks.iter().filter(|check| check.kind == kind);
    all.next().unwrap_or_else(|| panic!("no {kind:?}: {:?}", solved.checks))
}

#[test]
fn the_lateral_that_cannot_be_drilled_says_so() {
    let desk = Desk::new();
    let output = desk.done(&["run", &lateral(), "-o", "results"]);
    let text = String::from_utf8(output.stdout).unwrap();
    let summary = desk.summary("results");
    let solved = |operation: OperationKind, model| {
        let mut all = summary.operations.iter();
        let solved = all.find(|solved| solved.operation == operation && solved.model == model);
        solved.unwrap_or_else(|| panic!("{operation}"))
    };
    for operation in [OperationKind::TripIn, OperationKind::Slide] {
        for model in [ModelKind::Soft, ModelKind::Dynamic] {
            let solved = solved(operation, model);
            let errors = kinds(solved, Severity::Error);
            assert!(
                errors.is_superset(&[CheckKind::GoesDown, CheckKind::LockUp].into()),
                "{errors:?}"
            );
            let negative = found(solved, CheckKind::GoesDown);
            assert_eq!(negative.value, Some(solved.scalars.hook_load_N));
            let buckled = found(solved, CheckKind::HelicalBuckling);
            assert!(buckled.value > buckled.limit);
            // In the vertical part, at least into the build, and round the heel.
            assert!(buckled.md_m.unwrap() < 300.0, "{buckled:?}");
            assert!(solved.checks.windows(2).all(|pair| pair[0].severity >= pair[1].severity));
            let sentence = "The string does not go down by its weight: hook load ";
            let named = |line: &str| {
                line.starts_with(&format!("error: {operation} ("))
                    && line.contains(model.name())
                    && line.contains(sentence)
            };
            assert!(text.lines().any(named), "{text}");
        }
    }
    let slide = solved(OperationKind::Slide, ModelKind::Dynamic);
    let weight = found(slide, CheckKind::WeightOnBitNotReached);
    assert_eq!(weight.severity, Severity::Error);
    assert_eq!(weight.value, Some(slide.scalars.weight_on_bit_N));
    assert!((weight.limit.unwrap() / 49_033.25 - 1.0).abs() < 1e-9);
    // The most severe checks are listed first on the screen.
    let levels = text.lines().filter_map(|line| {
        let places = [Severity::Error, Severity::Warning, Severity::Note].into_iter();
        places.into_iter().find(|level| line.starts_with(&format!("{}: ", level.name())))
    });
    let levels: Vec<Severity> = levels.collect();
    assert!(levels.len() > 8 && levels.is_sorted_by(|a, b| a >= b), "{levels:?}");
}

#[test]
fn strict_ends_with_four() {
    let desk = Desk::new();
    let lateral = lateral();
    let arguments = [&["run", &lateral, "-o", "results", "--strict"], &SOFT[..]].concat();
    let output = desk.run(&arguments);
    assert_eq!(output.status.code(), Some(4));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(stderr, "error: errors were found: trip in (soft); slide (soft)\n");
    // All results exist.
    assert_eq!(desk.summary("results").operations.len(), 2);
    assert!(desk.path("results/report.html").exists());

    let valid = [&["run", "slant.toml", "--strict"], &SOFT[..]].concat();
    let output = desk.run(&valid);
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(!text.contains("error") && !text.contains("warning"), "{text}");
    for operation in desk.summary("out/Straight slant").operations {
        assert_eq!(operation.open_checks().next(), None);
    }
}

/// A string slides down a hole of 60° by its weight as long as its friction is below `1/tan 60°`,
/// 0.577.
#[test]
fn a_sweep_counts_what_was_found() {
    let desk = Desk::new();
    let arguments = |more: &[&'static str]| {
        let sweep = args("sweep slant.toml --vary friction=0.25,0.6 -o results");
        [&sweep[..], &["--set", "operation.kind=trip_in"], &SOFT, more].concat()
    };
    let output = desk.run(&arguments(&["--strict"]));
    assert_eq!(output.status.code(), Some(4));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(
        stderr,
        "error: errors were found in 1 of 2 cases\n  friction=0.6: trip in (soft)\n"
    );
    let text = desk.text("results/sweep.csv");
    let mut lines = text.lines().map(split);
    let heads = lines.next().unwrap();
    let place = |name: &str| heads.iter().position(|head| head == name).expect(name);
    let rows: Vec<Vec<String>> = lines.collect();
    let cell = |row: usize, name: &str| rows[row][place(name)].as_str();
    assert_eq!([cell(0, "errors"), cell(0, "warnings")], ["0", "0"]);
    assert_eq!([cell(0, "worst_check"), cell(0, "worst_check_sentence")], [""; 2]);
    assert_eq!([cell(1, "errors"), cell(1, "warnings")], ["2", "0"]);
    assert_eq!(cell(1, "worst_check"), "goes_down");
    let message = cell(1, "worst_check_sentence");
    assert!(message.starts_with("The string does not go down by its weight"), "{message}");

    assert_eq!(desk.run(&arguments(&["--resume"])).status.code(), Some(0));
    let strict = desk.run(&arguments(&["--resume", "--strict"]));
    assert_eq!(strict.status.code(), Some(4), "what was solved before counts too");
}

/// Cases that fail and cases with errors are both listed, with the status of the failure.
#[test]
fn a_sweep_lists_failures_and_errors() {
    let desk = Desk::new();
    let sweep = args(
        "sweep slant.toml --vary 'operation.wob=20 kN,2 MN' --set friction=0.6 -o results --quiet \
         --set 'model=[\"soft\", \"stiff\"]' --set 'operation.kind=[\"trip_in\", \"slide\"]'",
    );
    for (more, both) in [(&["--strict"][..], true), (&[], false)] {
        let overwrite = ["--overwrite"];
        let output = desk.run(&[&sweep[..], &overwrite, more].concat());
        assert_eq!(output.status.code(), Some(3));
        let stderr = String::from_utf8(output.stderr).unwrap();
        let wrong = stderr.find("error: errors were found in ");
        let failed =
            stderr.find("error: 1 of 2 cases failed\n").unwrap_or_else(|| panic!("{stderr}"));
        assert_eq!(wrong.is_some(), both, "{stderr}");
        assert!(wrong.is_none_or(|wrong| wrong < failed), "{stderr}");
        if both {
            let listed = &stderr[..failed];
            assert!(
                listed.contains("  operation.wob=20 kN: trip in (soft), trip in (stiff)"),
                "{stderr}"
            );
        }
        assert!(stderr[failed..].contains("  operation.wob=2 MN: slide: "), "{stderr}");
        assert!(!stderr[failed..].contains("  operation.wob=20 kN: "), "{stderr}");
    }
}

#[test]
fn a_study_shows_the_numbers_of_checks() {
    let desk = Desk::new();
    let study = r#"
name = "Which goes down"

[[sweep]]
name = "slant"
case = "slant.toml"
set = { model = "soft", "operation.kind" = "trip_in" }
vary = { friction = [0.25, 0.6] }

[[table]]
title = "Errors"

[[table.row]]
label = "little friction"
column = "errors"
only = { friction = 0.25 }

[[table.row]]
label = "much friction"
column = "errors"
only = { friction = 0.6 }
"#;
    fs::write(desk.path("study.toml"), study).unwrap();
    let output = desk.run(&["study", "study.toml", "-o", "results"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0), "{stderr}");
    let table = desk.text("results/tables/table-01.csv");
    let mut lines = table.lines().map(split);
    let heads = lines.next().unwrap();
    let place = heads.iter().position(|head| head == "computed").unwrap();
    let computed: Vec<String> = lines.map(|row| row[place].clone()).collect();
    assert_eq!(computed, ["0", "2"]);
    let strict = desk.run(&args("study study.toml -o results --resume --strict"));
    assert_eq!(strict.status.code(), Some(4));
}
