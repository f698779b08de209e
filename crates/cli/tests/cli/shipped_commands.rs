//! Each shipped case with each command that applies to it: a result, or the reason why there is
//! none.

use std::path::Path;

use serde_json::Value;
use wholestring::well::FrictionLevel;
use wholestring_cases::{ALL, LATERAL_THAT_CANNOT_BE_DRILLED, ReadyCase};
use wholestring_results::{PlanSummary, ReachSummary, Severity, Table};

use crate::desk::{Desk, transcript};

/// Path of a shipped case.
fn path(case: &ReadyCase) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    folder.join(case.file_name).to_str().unwrap().to_owned()
}

/// Runs a command on each shipped case into the folder `out`, and checks its results.
fn each_answers(command: &[&str], more: &[&str], look: impl Fn(&ReadyCase, &Desk)) {
    for case in ALL {
        let desk = Desk::new();
        desk.done(&[command, &[&path(case)], more].concat());
        look(case, &desk);
    }
}

/// The missing numbers of a summary, by their paths, except members whose absence is a result.
fn missing_numbers(value: &Value, path: &str, missing: &mut Vec<String>) {
    match value {
        Value::Null => missing.push(path.to_owned()),
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                missing_numbers(item, &format!("{path}[{index}]"), missing);
            }
        }
        Value::Object(members) => {
            for (key, member) in members {
                missing_numbers(member, &format!("{path}.{key}"), missing);
            }
        }
        _ => {}
    }
}

#[test]
fn every_case_is_valid() {
    each_answers(&["check"], &[], |_, _| ());
}

/// The survey and the tally of a case are written, and `survey` reads the survey again.
#[test]
fn every_case_exports_its_survey_and_its_string() {
    let out = ["-o", "out.csv", "--what"];
    each_answers(&["export", "--to", "csv"], &[&out[..], &["survey"]].concat(), |case, desk| {
        let output = desk.done(&["survey", "out.csv", "-o", "positions.csv"]);
        let positions = Table::read_csv(&desk.path("positions.csv")).unwrap();
        assert!(positions.rows() > 1, "{}: {}", case.name, transcript(&output));
    });
    each_answers(&["export", "--to", "csv"], &[&out[..], &["tally"]].concat(), |case, desk| {
        assert!(desk.text("out.csv").lines().count() > 2, "{}", case.name);
    });
}

#[test]
fn every_assembly_is_analysed() {
    let few = ["--inclination", "30deg", "-o", "out"];
    each_answers(&["bha"], &few, |case, desk| {
        let summary: Value = serde_json::from_str(&desk.text("out/summary.json")).unwrap();
        let mut missing = Vec::new();
        missing_numbers(&summary["state"], "state", &mut missing);
        assert!(missing.is_empty(), "{}: {missing:?}", case.name);
    });
}

/// Each point of a plan has numbers or the reason why it has none. Shipped wells are valid: with
/// expected friction no check is an error, except in the lateral that is shipped for that purpose.
#[test]
fn every_case_is_planned() {
    each_answers(&["plan"], &["--set", "plan.depths=2", "-o", "out"], |case, desk| {
        let plan = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
        assert!(!plan.points.is_empty(), "{}", case.name);
        for point in &plan.points {
            let reason = point.message.is_some() && point.worst.is_some();
            assert!(point.scalars.is_some() != reason, "{}: {point:?}", case.name);
        }
        let deepest_m = plan.bit_depths_m.last().copied();
        let expected = plan.points.iter().filter(|point| {
            point.friction == FrictionLevel::Expected && Some(point.bit_depth_m) == deepest_m
        });
        let errors: Vec<_> = expected
            .filter_map(|point| point.worst.as_ref())
            .filter(|check| check.severity == Severity::Error)
            .collect();
        let wrong = case.name == LATERAL_THAT_CANNOT_BE_DRILLED.name;
        assert_eq!(!errors.is_empty(), wrong, "{}: {errors:?}", case.name);
    });
}

/// Each operation of a reach has a check with a sentence, and each limit either a depth or the
/// margin at the deepest bit depth.
#[test]
fn every_case_has_a_reach() {
    each_answers(&["reach"], &["-o", "out", "--to", "5km"], |case, desk| {
        let reach = ReachSummary::read(&desk.path("out/summary.json")).unwrap();
        assert!(!reach.checks.is_empty(), "{}", case.name);
        for row in &reach.checks {
            assert!(row.check.sentence.ends_with(|end: char| end.is_alphanumeric()), "{row:?}");
        }
    });
}

/// A sweep of each case by the soft string; its page is rebuilt, and its figures are drawn.
#[test]
fn every_case_is_swept_reported_and_plotted() {
    let two = ["--vary", "mud.density=1100kg/m3,1150kg/m3", "-o", "out"];
    for case in ALL {
        let desk = Desk::new();
        let case_path = path(case);
        let arguments = [&["sweep", &case_path, "--set", "model=soft"], &two[..]].concat();
        let output = desk.run(&arguments);
        assert!(output.status.success(), "{}: {}", case.name, transcript(&output));
        desk.done(&["report", "out"]);
        desk.done(&["plot", "out"]);
    }
}
