//! The weight on bit of the case that is planned.

use wholestring_results::PlanSummary;

/// Weight on bit of what drills, N.
pub(super) fn on_bit_N(summary: &PlanSummary) -> Option<f64> {
    let drills = summary.operations.iter().any(|of| of == "drill" || of == "slide");
    summary.settings["operation"]["wob_N"].as_f64().filter(|_| drills)
}
