//! All pictures of a plan.

use super::{Plan, broomstick, buckling, mud, peaks};
use crate::{Plot, figure::Figure, plots::Shown};

/// Every picture of a plan, in a set of units (`si`, `metric` or `field`): `hook_load`, `torque`,
/// `buckling_weight`, `hydraulics` and `peaks`; of each only where there is something to draw.
pub fn plan_plots(plan: &Plan, units: &str) -> Vec<Plot> {
    let shown = Shown::new(&plan.head.dimensions, units);
    let pictures = [
        ("hook_load", broomstick::hook_load(plan, shown)),
        ("torque", broomstick::torque(plan, shown)),
        ("buckling_weight", buckling::figure(plan, shown)),
        ("hydraulics", mud::figure(plan, shown)),
        ("peaks", peaks::figure(plan, shown)),
    ];
    let plot =
        |(name, figure): (&str, Option<Figure>)| Some(Plot { name: name.into(), figure: figure? });
    pictures.into_iter().filter_map(plot).collect()
}
