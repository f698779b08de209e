//! Checks of a reach.

use wholestring::operation::OperationKind;
use wholestring_judge::{DepthLimit, Judge, Reached};
use wholestring_results::{ReachCheck, ReachOfFriction};

/// Reach of each operation at each friction factor, as checks in the units of the judge.
pub(super) fn checks(
    frictions: &[ReachOfFriction],
    [from_m, to_m]: [f64; 2],
    planned_m: f64,
    judge: &Judge,
) -> Vec<ReachCheck> {
    let mut checks = Vec::new();
    for found in frictions {
        let mut operations: Vec<OperationKind> = Vec::new();
        for limit in &found.limits {
            if !operations.contains(&limit.operation) {
                operations.push(limit.operation);
            }
        }
        for operation in operations {
            let stops =
                found.limits.iter().filter(|limit| limit.stops && limit.operation == operation);
            let met = stops.filter_map(|limit| Some((limit.depth_m?, limit.limit)));
            let zero = found.limits.iter().find(|limit| {
                limit.operation == operation
                    && limit.limit == DepthLimit::HookLoadZero
                    && !limit.stops
            });
            let reached = Reached {
                operation: operation.words(),
                stopped: met.min_by(|a, b| a.0.total_cmp(&b.0)),
                pushed_from_m: zero.and_then(|limit| limit.depth_m),
                from_m,
                planned_m,
                to_m,
            };
            checks.push(ReachCheck {
                operation,
                friction: found.friction,
                check: judge.reach(&reached),
            });
        }
    }
    checks
}
