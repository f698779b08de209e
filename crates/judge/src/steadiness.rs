//! Whether the means of a dynamic run are steady, and the depth at which they are taken.

use wholestring::{operation::Operation, outcome::InTime};

use crate::{Check, CheckKind, Severity};

/// Travel of the bit in the window, m, from which a drift depends on depth as much as on the start.
const TRAVELS_M: f64 = 1.0;

/// Largest difference, m, between the requested depth and the mean depth of the bit over the
/// window.
const ELSEWHERE_M: f64 = 1.0;

/// Returns the checks of a run that was computed to its end.
pub fn checks(operation: &Operation, run: &InTime<'_>) -> Vec<Check> {
    let numerics = run.numerics;
    let mut found = Vec::new();
    if numerics.settled == Some(false) {
        found.push(
            Check::reported(CheckKind::NeverSteady, Severity::Warning).value(numerics.settle_s),
        );
    }
    if run.statistics.iter().any(|(_, statistic)| statistic.drifts) {
        let travels = numerics.bit_travel_m.abs() >= TRAVELS_M;
        let severity = if travels { Severity::Note } else { Severity::Warning };
        found.push(Check::reported(CheckKind::WindowDrifts, severity));
    }
    // A user who gives the time has thereby chosen the depth.
    let off_m = numerics.mean_bit_depth_m - operation.bit_depth_m;
    if numerics.settled.is_some() && off_m.abs() >= ELSEWHERE_M {
        found.push(
            Check::reported(CheckKind::BitElsewhere, Severity::Note)
                .value(numerics.mean_bit_depth_m)
                .limit(operation.bit_depth_m),
        );
    }
    found
}
