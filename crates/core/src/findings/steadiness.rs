//! Whether the means of a dynamic run stand still, and where they are taken.

use super::{Finding, Kind, Level};
use crate::{dynamics::DynamicOutcome, operation::Operation};

/// Travel of the bit in the window from which a drift is one of the place as much as of the start,
/// m.
const TRAVELS_M: f64 = 1.0;

/// How far from the requested depth the bit may be on average over the window, m.
const ELSEWHERE_M: f64 = 1.0;

/// Of a run that was computed to its end.
pub fn findings(operation: &Operation, outcome: &DynamicOutcome) -> Vec<Finding> {
    let of = &outcome.numerics;
    let mut found = Vec::new();
    if of.settled == Some(false) {
        found.push(Finding::new(Kind::NeverSteady, Level::Warning).value(of.settle_s));
    }
    if outcome.statistics.iter().any(|(_, of)| of.drifts) {
        let level = if of.bit_travel_m.abs() >= TRAVELS_M { Level::Note } else { Level::Warning };
        found.push(Finding::new(Kind::WindowDrifts, level));
    }
    // Who gives the time has chosen the place.
    let off_m = of.mean_bit_depth_m - operation.bit_depth_m;
    if of.settled.is_some() && off_m.abs() >= ELSEWHERE_M {
        found.push(
            Finding::new(Kind::BitElsewhere, Level::Note)
                .value(of.mean_bit_depth_m)
                .limit(operation.bit_depth_m),
        );
    }
    found
}
