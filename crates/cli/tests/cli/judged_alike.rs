//! One state judged by several commands: what `run` warns of, `plan` and `reach` do too.

use std::fs;

use wholestring_results::{CheckKind, OperationSummary, PlanSummary, ReachSummary, Severity};

use crate::desk::{Desk, transcript};

/// A lateral of 2800 m into which only the block pushes the string.
const LATERAL: &str = r#"
name = "Pushed"
model = ["soft", "stiff"]

[well]
path = "minimum-curvature"
stations = [[0, 0, 0], [600, 0, 0], [1200, 90, 0], [4000, 90, 0]]

[[well.hole]]
kind = "casing"
to = 1200
diameter = "220.5 mm"
friction = 0.25

[[well.hole]]
kind = "open"
to = 4000
diameter = "215.9 mm"
friction = 0.35

[mud]
density = "1.2 sg"

[[string]]
component = "bit"
od = "215.9 mm"
length = "0.3 m"

[[string]]
component = "drill pipe"
od = "127 mm"
id = "108.6 mm"
length = "to surface"
make_up_torque = "12 kN.m"

[rig]
block_weight = "400 kN"

[operation]
kind = ["trip_in", "rotate_off_bottom", "ream"]
bit_depth = 4000
rpm = 60
trip_speed = "0.2 m/s"
"#;

fn desk() -> Desk {
    let desk = Desk::new();
    fs::write(desk.path("pushed.toml"), LATERAL).unwrap();
    desk
}

fn severity(solved: &OperationSummary, kind: CheckKind) -> Option<Severity> {
    let mut checks = solved.checks.iter().filter(|check| check.kind == kind);
    checks.next().map(|check| check.severity)
}

fn reach_of(desk: &Desk, folder: &str) -> ReachSummary {
    ReachSummary::read(&desk.path(folder).join("summary.json")).unwrap()
}

/// A string that only the block pushes is warned of by run, plan and reach, and reach stops where
/// run finds the make-up torque exceeded.
#[test]
fn a_push_of_the_block_and_make_up_torque_are_the_same_everywhere() {
    let desk = desk();
    desk.run(&["run", "pushed.toml", "-o", "run", "-q", "--set", "model=soft"]);
    let run = desk.summary("run");
    let [trip_in, rotate, _] = &run.operations[..] else { panic!("three operations") };
    assert_eq!(severity(trip_in, CheckKind::GoesDown), Some(Severity::Warning));
    assert_eq!(severity(rotate, CheckKind::MakeUp), Some(Severity::Error));

    desk.done(&["plan", "pushed.toml", "-o", "plan", "-q", "--set", "plan.depths=3"]);
    let plan = PlanSummary::read(&desk.path("plan/summary.json")).unwrap();
    let mut points = plan.points.iter().filter(|point| point.worst.is_some());
    assert!(points.any(|point| {
        point.worst.as_ref().is_some_and(|worst| worst.kind == CheckKind::GoesDown)
    }));

    desk.done(&["reach", "pushed.toml", "-o", "reach", "-q"]);
    let reach = reach_of(&desk, "reach");
    let sentence = |words: &str| {
        let mut checks = reach.checks.iter().map(|row| &row.check);
        checks.find(|check| check.sentence.starts_with(words)).expect("a check").clone()
    };
    let pushed = sentence("trip in");
    assert!(pushed.severity >= Severity::Warning, "{}", pushed.sentence);
    assert!(pushed.sentence.contains("it must be pushed"), "{}", pushed.sentence);
    let turned = sentence("rotate off bottom");
    assert_eq!(turned.severity, Severity::Error, "{}", turned.sentence);
    assert!(turned.sentence.ends_with("make-up torque"), "{}", turned.sentence);
}

/// Models and operations of the case that a plan does not compute are named.
#[test]
fn a_plan_names_what_it_leaves_out() {
    let desk = desk();
    let output = desk.done(&["plan", "pushed.toml", "-o", "plan", "--set", "plan.depths=3"]);
    let text = transcript(&output);
    for phrase in [
        "not checked: torque and drag by the stiff string (`plan.models` does not list it)",
        "not checked: ream (`plan.operations` does not list `ream`)",
    ] {
        assert!(text.contains(phrase), "{text}");
    }
    let set = ["--set", "plan.models=[\"soft\", \"stiff\"]", "--set", "model=soft"];
    let arguments = ["plan", "pushed.toml", "-o", "all", "--set", "plan.depths=3"];
    let output = desk.done(&[&arguments[..], &set].concat());
    assert!(!transcript(&output).contains("the stiff string ("), "{}", transcript(&output));
}

/// Models whose values differ have lines of their own.
#[test]
fn models_that_differ_are_not_one_line() {
    let desk = desk();
    let output = desk.run(&["run", "pushed.toml", "-o", "run"]);
    let text = transcript(&output);
    let summary = desk.summary("run");
    let value = |index: usize| {
        let checks = &summary.operations[index].checks;
        let mut checks = checks.iter().filter(|check| check.kind == CheckKind::GoesDown);
        checks.next().and_then(|check| check.value).expect("a value")
    };
    let [soft, stiff] = [value(0), value(1)];
    let lines = text.lines().filter(|line| line.contains("The string does not go down"));
    let expected = if (soft - stiff).abs() > 0.05 * soft.abs().max(stiff.abs()) { 2 } else { 1 };
    assert_eq!(lines.count(), expected, "{soft} {stiff}\n{text}");
}

/// A string in a hole that ends above the end of the survey begins where the hole ends.
#[test]
fn a_reach_begins_where_the_hole_ends() {
    let desk = desk();
    let text = LATERAL.replace("to = 4000\n", "to = 1500\n");
    let text = text.replace("bit_depth = 4000", "bit_depth = 1500");
    fs::write(desk.path("short.toml"), text).unwrap();
    desk.done(&["reach", "short.toml", "-o", "reach", "-q"]);
    assert_eq!(reach_of(&desk, "reach").from_m, 1500.0);
}
