//! Checks of the points of a bit test.

use wholestring_judge::{Check, TriedPoint, bit_test_checks};
use wholestring_results::{BitTestPoint, Status};

/// Returns the checks of all points, the most severe first.
pub(super) fn checks(points: &[BitTestPoint]) -> Vec<Check> {
    let tried = points.iter().map(|point| {
        let failure = match &point.status {
            Status::Failed(reason) => Some(reason.as_str()),
            _ => None,
        };
        TriedPoint { name: &point.point, failure, outcome: point.outcome.as_ref() }
    });
    bit_test_checks(&tried.collect::<Vec<_>>())
}
