//! Forces across the string that a model leaves out.

use super::{Finding, Kind, Level};
use crate::model::Model;

/// Of the soft string, which has no stiffness that could carry them.
pub fn left_out(model: &Model) -> Option<Finding> {
    let forces = model.string.components().iter().filter_map(|of| of.lateral_force);
    let sum_N: f64 = forces.map(|of| of.force_N.abs()).sum();
    (sum_N > 0.0).then(|| Finding::new(Kind::LateralForceLeftOut, Level::Note).value(sum_N))
}
