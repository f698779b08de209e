//! Side force of the wall on the joints of pipe.

use wholestring::model::Model;

use crate::{Check, CheckKind, Checks, LimitSettings, Missing, loads::Loads};

/// Adds the largest side force per joint of each component that has joints.
pub fn limits(model: &Model, loads: &Loads<'_>, settings: &LimitSettings, checks: &mut Checks) {
    let kind = CheckKind::SideForce;
    let components = model.string.components();
    let Some(limit_N) = settings.side_force_per_joint_N else {
        if components.iter().any(|component| component.joints.is_some()) {
            checks.lacks(kind, None, Missing::SideForceLimit);
        }
        return;
    };
    let mut largest = vec![None::<(f64, usize)>; components.len()];
    for (row, force_N) in loads.profile.side_force_per_joint_N.iter().enumerate() {
        let Some(force_N) = force_N.map(f64::abs) else { continue };
        let slot = &mut largest[loads.component_above(row)];
        if slot.is_none_or(|(largest_N, _)| force_N > largest_N) {
            *slot = Some((force_N, row));
        }
    }
    for (component, found) in components.iter().zip(largest) {
        let Some((force_N, row)) = found else { continue };
        let check = Check::load(kind, force_N, limit_N, settings.factors.required(kind));
        let place = |check: Check| check.of_component(&component.name).at(loads.profile.md_m[row]);
        checks.checks.extend(check.map(place));
    }
}
