//! All pictures of a plan.

use super::{Plan, broomstick, buckling, mud, peaks};
use crate::{
    Plot,
    plots::{Shown, named},
    uncertain,
};

/// Names of the pictures of a plan.
pub const PLAN_PICTURES: [&str; 6] =
    ["hook_load", "torque", "buckling_weight", "hydraulics", "uncertain", "peaks"];

/// Every picture of a plan, in a set of units (`si`, `metric` or `field`), where there is something
/// to draw.
pub fn plan_plots(plan: &Plan, units: &str) -> Vec<Plot> {
    let shown = Shown::new(&plan.head.dimensions, units);
    let owed = plan.uncertain.as_ref();
    let figures = [
        broomstick::hook_load(plan, shown),
        broomstick::torque(plan, shown),
        buckling::figure(plan, shown),
        mud::figure(plan, shown),
        owed.and_then(|of| uncertain::figure(of, &plan.head.title)),
        peaks::figure(plan, shown),
    ];
    named(PLAN_PICTURES, figures)
}
