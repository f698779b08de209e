//! Forces across the string that a model leaves out.

use wholestring::model::Model;

use crate::{Check, CheckKind, Severity};

/// Reports the lateral forces that the soft string leaves out, because it has no stiffness that
/// could carry them.
pub fn left_out(model: &Model) -> Option<Check> {
    let components = model.string.components().iter();
    let forces = components.filter_map(|component| component.lateral_force);
    let sum_N: f64 = forces.map(|lateral| lateral.force_N.abs()).sum();
    let check = || Check::reported(CheckKind::LateralForceLeftOut, Severity::Note).value(sum_N);
    (sum_N > 0.0).then(check)
}
