use std::path::Path;

use wholestring_units::UnitSet;

use super::*;
use crate::{cancellation::CancellationToken, cores, keep::Keep, observer::Silent};

/// A model from the test data of the command line.
fn slant() -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cli/tests/data/slant.toml");
    wholestring_case::load(&path, &[]).expect("a valid case")
}

#[test]
fn who_interrupts_the_laying_does_not_wait_for_the_run() {
    let case = slant();
    let place = tempfile::tempdir().expect("a folder");
    let folder = ResultsFolder::create(place.path()).expect("a folder");
    let mut record = Record::begin(&case, UnitSet::Si, &folder).expect("a record");
    let cancelled = CancellationToken::new();
    cancelled.cancel();
    let status = solve_dynamic(
        &case,
        &case.operations[0],
        &way(&cancelled),
        &mut record,
        &mut Keeper::new(&folder, Duration::MAX),
        None,
    );
    assert_eq!(status, Status::Interrupted);
    assert!(record.summary.operations.is_empty());
}

#[test]
fn what_comes_before_the_first_step_is_said() {
    let case = slant();
    let text = preparation(&case.dynamics, &case.operations[0]);
    assert_eq!(text, "initialising the string");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/rock-300.toml");
    let case = wholestring_case::load(&path, &[]).expect("a valid case");
    let text = preparation(&case.dynamics, &case.operations[0]);
    assert!(text.ends_with("running the bit in on the rock"), "{text}");
}

/// An operation without a solution is reported with those that have one; a dynamic one ends the
/// run.
#[test]
fn an_operation_without_answer_keeps_what_was_solved() {
    let mut case = slant();
    // Deeper than the string is long, which the checks of a case file do not allow.
    case.operations[1].bit_depth_m += 100.0;
    let place = tempfile::tempdir().expect("a folder");
    let folder = ResultsFolder::create(place.path()).expect("a folder");
    for (model, count) in [(ModelKind::Soft, 2), (ModelKind::Dynamic, 0)] {
        case.models = vec![model];
        // Results of an earlier run are not mistaken for those of this one.
        if model == ModelKind::Dynamic {
            case.operations.remove(0);
        }
        let mut record = Record::begin(&case, UnitSet::Si, &folder).expect("a record");
        let cancelled = CancellationToken::new();
        let stop = solve(&case, &way(&cancelled), &mut record, Some(&folder), None).unwrap_err();
        let Stop::Unsolved(message) = stop else {
            panic!("{stop:?}");
        };
        assert!(message.contains("has no answer: "), "{message}");
        let summary = place.path().join("summary.json");
        let summary = wholestring_results::Summary::read(&summary).expect("a summary");
        assert_eq!(summary.operations.len(), count);
        let failed = |summary: &wholestring_results::OperationSummary| {
            matches!(summary.status, wholestring_results::Status::Failed(_))
        };
        assert_eq!(
            summary.operations.iter().filter(|operation| failed(operation)).count(),
            count / 2
        );
    }
}

fn way(cancellation: &CancellationToken) -> Way<'_> {
    Way {
        keep: Keep::All,
        csv: false,
        checkpoint_every: Duration::MAX,
        watch: Watch { observer: &Silent, case: 0 },
        cancellation,
        executor: cores::alone(cancellation),
    }
}
