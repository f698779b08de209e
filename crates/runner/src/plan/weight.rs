//! Weight on bit of the planned case.

use wholestring_results::PlanSummary;

/// Weight on bit of the drilling operations, N.
pub(super) fn on_bit_N(summary: &PlanSummary) -> Option<f64> {
    let drills = summary.operations.iter().any(|operation| operation.on_bottom());
    summary.settings["operation"]["wob_N"].as_f64().filter(|_| drills)
}
