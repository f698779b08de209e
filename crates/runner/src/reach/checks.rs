//! Checks of a reach.

use wholestring_judge::{DepthLimit, Judge, Reached};
use wholestring_plan::reach::OperationReach;
use wholestring_results::ReachCheck;

/// Reach of each operation at each friction factor, as checks in the units of the judge.
pub(super) fn checks(
    answers: &[(Option<f64>, &[OperationReach])],
    [from_m, to_m]: [f64; 2],
    planned_m: f64,
    rig_pushes: bool,
    judge: &Judge,
) -> Vec<ReachCheck> {
    let check = |friction: Option<f64>, reach: &OperationReach| {
        let zero = reach.curves.iter().find(|curve| curve.limit == DepthLimit::HookLoadZero);
        let reached = Reached {
            operation: reach.kind.words(),
            stopped: reach.stop().map(|(depth_m, curve)| (depth_m, curve.limit)),
            pushed_from_m: zero.filter(|zero| !zero.stops).and_then(|zero| zero.end.depth_m()),
            rig_pushes,
            from_m,
            planned_m,
            to_m,
        };
        ReachCheck { operation: reach.kind, friction, check: judge.reach(&reached) }
    };
    let each = answers.iter();
    each.flat_map(|(friction, reaches)| reaches.iter().map(|reach| check(*friction, reach)))
        .collect()
}
