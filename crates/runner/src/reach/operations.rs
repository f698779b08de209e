//! Operations of a case whose limits are evaluated, and the checks of a reach.

use wholestring::operation::{Operation, OperationKind};
use wholestring_case::Case;
use wholestring_judge::{DepthLimit, Judge, Reached};
use wholestring_plan::reach::OperationReach;
use wholestring_results::ReachCheck;

use crate::error::Error;

/// Operations that are evaluated by default.
const USUAL: [OperationKind; 5] = [
    OperationKind::TripOut,
    OperationKind::RotateOffBottom,
    OperationKind::Drill,
    OperationKind::TripIn,
    OperationKind::Slide,
];

/// Operations, and sentences on those that are left out.
pub(super) struct Operations {
    pub(super) all: Vec<Operation>,
    pub(super) left_out: Vec<String>,
}

/// The requested operations; by default the usual ones and those of the case, if the case has their
/// set points.
pub(super) fn operations(case: &Case, requested: &[OperationKind]) -> Result<Operations, Error> {
    let mut found = Operations { all: Vec::new(), left_out: Vec::new() };
    if !requested.is_empty() {
        for kind in requested {
            found.all.push(operation(case, *kind).map_err(Error::BadInput)?);
        }
        return Ok(found);
    }
    let of_case = case.operations.iter().map(|operation| operation.kind);
    let more = of_case.filter(|kind| !USUAL.contains(kind));
    for kind in USUAL.into_iter().chain(more) {
        match operation(case, kind) {
            Ok(operation) => found.all.push(operation),
            Err(why) => found.left_out.push(why),
        }
    }
    Ok(found)
}

/// The case's operation of a kind; if there is none, one with the set points of another.
pub(crate) fn operation(case: &Case, kind: OperationKind) -> Result<Operation, String> {
    let of_kind = case.operations.iter().find(|operation| operation.kind == kind);
    // Uses the case's set points, except that some laws determine the bit's torque and rate
    // themselves.
    let alike =
        || case.operations.iter().find(|operation| operation.kind.on_bottom() == kind.on_bottom());
    let found = of_kind.or_else(alike).or(case.operations.first());
    let Some(found) = found else {
        return Err("the case has no operation".into());
    };
    let operation = Operation { kind, ..*found };
    let lacks =
        |what: &str| Err(format!("`{}` is left out: [operation] has no {what}", kind.name()));
    if kind.rotates() && operation.rotary_speed_rad_per_s <= 0.0 {
        return lacks("rpm");
    }
    if kind.on_bottom() && operation.weight_on_bit_N <= 0.0 {
        return lacks("wob");
    }
    Ok(operation)
}

// Checks of a reach.

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
