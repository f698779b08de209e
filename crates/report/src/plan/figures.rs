//! All pictures of a plan.

use super::{Plan, broomstick, buckling, mud, peaks};
use crate::{
    Plot,
    plots::{DisplayUnits, named},
    uncertain,
};

/// Names of the pictures of a plan.
pub const PLAN_PICTURES: [&str; 6] =
    ["hook_load", "torque", "buckling_weight", "hydraulics", "uncertain", "peaks"];

/// Returns every picture of a plan with content, in a set of units (`si`, `metric` or `field`).
pub fn plan_plots(plan: &Plan, units: &str) -> Vec<Plot> {
    let display = DisplayUnits::new(&plan.head.dimensions, units);
    let owed = plan.samples();
    let figures = [
        broomstick::hook_load(plan, display),
        broomstick::torque(plan, display),
        buckling::figure(plan, display),
        mud::figure(plan, display),
        owed.and_then(|samples| uncertain::figure(samples, &plan.head.title)),
        peaks::figure(plan, display),
    ];
    named(PLAN_PICTURES, figures)
}
