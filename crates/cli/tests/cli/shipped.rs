//! The shipped cases.

use std::path::Path;

use crate::desk::Desk;
use wholestring::outcome::ModelKind;
use wholestring_results::{OperationSummary, Severity, Status};

/// Runs the shipped case with these windows and returns the operations of its `summary.json`.
fn solved(case: &Path, settle: &str, duration: &str) -> Vec<OperationSummary> {
    solved_with(
        case,
        &[&format!("dynamics.settle={settle}"), &format!("dynamics.duration={duration}")],
    )
}

/// The same with overrides.
fn solved_with(case: &Path, changes: &[&str]) -> Vec<OperationSummary> {
    let desk = Desk::new();
    let case = case.to_str().unwrap();
    let mut arguments = vec!["run", case, "-o", "results"];
    for change in changes {
        arguments.extend(["--set", *change]);
    }
    desk.done(&arguments);
    desk.summary("results").operations
}

fn cases() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

/// From the case file to `summary.json`, the dynamics of a quiet string agree with the soft string:
/// its hook load, and its friction torque reduced to `1/√(1 + μ²)` by the climb of a rotating pipe.
///
/// The hook load may differ by 1 % and the torque by 2 %: bending bridges the ends of the build and
/// the bit carries the motor, 0.42 % of the torque after a settling of 20 s; the rest allows for a
/// settling of only 5 s.
#[test]
fn np13_with_both_models() {
    let solved = solved(&cases().join("np13-x1042.toml"), "5 s", "2 s");
    let [soft, dynamic] = &solved[..] else {
        panic!("one operation with two models");
    };
    assert_eq!([soft.model, dynamic.model], [ModelKind::Soft, ModelKind::Dynamic]);
    let apart = |found: f64, expected: f64| (found / expected - 1.0).abs();
    let (hook_N, soft_hook_N) = (dynamic.scalars.hook_load_N, soft.scalars.hook_load_N);
    assert!(apart(hook_N, soft_hook_N) < 0.01, "{hook_N} for {soft_hook_N} N");
    let climbed_N_m = soft.scalars.friction_torque_N_m / 0.3_f64.hypot(1.0);
    let torque_N_m = dynamic.scalars.friction_torque_N_m;
    assert!(apart(torque_N_m, climbed_N_m) < 0.02, "{torque_N_m} for {climbed_N_m} N·m");
    let numerics = dynamic.numerics.as_ref().unwrap();
    assert!(numerics.run.added_axial_mass_fraction < 0.005, "{numerics:?}");
}

/// The dynamics of the shipped case with its own settings: each operation was steady when its
/// window began, and the deviation of its hook load is no drift, except where the string travels,
/// because its hook load changes with its position.
fn settles(name: &str) {
    let solved = solved_with(&cases().join(name), &["model=dynamic"]);
    for operation in &solved {
        let numerics = operation.numerics.as_ref().unwrap();
        let hook_load = operation.statistics.as_ref().unwrap()["hook_load_N"];
        assert_eq!(numerics.run.settled, Some(true), "{name}: {}", operation.operation);
        let travels = numerics.run.bit_travel_m.abs() > 1.0;
        assert!(!hook_load.drifts || travels, "{name}, {}: {hook_load:?}", operation.operation);
    }
}

#[test]
fn cases_that_trip_settle() {
    for name in ["slant.toml", "vertical.toml", "horizontal.toml", "iscwsa-04.toml"] {
        settles(name);
    }
}

#[test]
fn every_case_runs_to_its_end() {
    for shipped in wholestring_cases::ALL {
        let (path, text) = (cases().join(shipped.file_name), shipped.text);
        let solved = if text.contains("law = \"rock\"") {
            // Long elements, which take a fiftieth of the time or less, and are not too heavy for
            // the bit.
            let coarse = [
                "rock.element_size=24 mm",
                "rock.density_factor=500",
                "dynamics.settle=0.1 s",
                "dynamics.duration=0.1 s",
            ];
            solved_with(&path, &coarse)
        } else {
            solved(&path, "0.5 s", "0.5 s")
        };
        // Well B follows a schedule, which a soft string does not model.
        let scheduled = text.contains("schedule = [");
        for model in [ModelKind::Soft, ModelKind::Dynamic] {
            let mut lines = text.lines().filter(|line| line.starts_with("model ="));
            let named = lines.next().is_none_or(|line| line.contains(model.name()));
            let expected = named && (model == ModelKind::Dynamic || !scheduled);
            assert_eq!(solved.iter().any(|solved| solved.model == model), expected, "{path:?}");
        }
        // One case is wrong on purpose; for the others the soft string finds no error. These
        // windows are too short for the dynamics.
        let wrong = path.ends_with("lateral-that-cannot-be-drilled.toml");
        for operation in &solved {
            assert_eq!(operation.status, Status::Complete, "{path:?}: {}", operation.operation);
            if operation.model == ModelKind::Soft {
                let errors =
                    operation.checks.iter().filter(|check| check.severity == Severity::Error);
                assert_eq!(errors.count() > 0, wrong, "{path:?}: {:?}", operation.checks);
            }
        }
    }
}
