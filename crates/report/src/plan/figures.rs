//! All pictures of a plan.

use super::{Plan, broomstick, buckling, mud};
use crate::{
    Plot,
    plots::{Shown, named},
};

/// Names of the pictures of a plan.
pub const PLAN_PICTURES: [&str; 4] = ["hook_load", "torque", "buckling_weight", "hydraulics"];

/// Every picture of a plan, in a set of units (`si`, `metric` or `field`), where there is something
/// to draw.
pub fn plan_plots(plan: &Plan, units: &str) -> Vec<Plot> {
    let shown = Shown::new(&plan.head.dimensions, units);
    let figures = [
        broomstick::hook_load(plan, shown),
        broomstick::torque(plan, shown),
        buckling::figure(plan, shown),
        mud::figure(plan, shown),
    ];
    named(PLAN_PICTURES, figures)
}
