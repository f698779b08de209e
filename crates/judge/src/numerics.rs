//! Reliability of the numbers of a dynamic run.

use wholestring::{
    dynamics::{Numerics, TableUse},
    model::Model,
    operation::Operation,
    outcome::{Profile, Scalars, Solution},
    rod::buckled_element::BuckledElement,
    sizing::SizeReason,
    statics::stiff::Convergence,
};

use crate::{Check, CheckKind, Severity, window::Window};

/// Part of the string's mean clearance. A wall is to hold a pipe at the clearance that the hole
/// leaves it. A tenth more moves the pipe by as much as hole sizes are uncertain; with as much
/// again it is another hole.
const DEEP: f64 = 0.1;
const THROUGH: f64 = 1.0;

/// Energy that the integration gained or lost, as a share: as much as torque and drag of a good
/// model differ from those of a rig.
const RESIDUAL: f64 = 0.05;

/// Share beyond which friction, which determines torque and drag, is no longer the computed one.
const LOST: f64 = 0.2;

/// Ratio of the variation of a node's tension to the median of its neighbours above which the node
/// counts as unsettled.
const RESTLESS: f64 = 10.0;

/// Distance within which nodes are neighbours, m.
const NEIGHBOURS_M: f64 = 100.0;

/// Part of the largest tension or compression by which the tension of an unsettled node must also
/// vary.
const SWINGS: f64 = 0.02;

/// A bit whose weight varies by more than this part of its mean shakes the string.
const SHAKEN: f64 = 0.02;

/// Reports a static equilibrium that is not stable, and where the string would roll around its hole
/// for ever instead: a note where it [bows in a vertical hole](crate::buckling::bows_in_vertical_hole)
/// alone.
pub fn equilibrium(convergence: &Convergence, bows_in_vertical_hole: bool) -> Option<Check> {
    let check = unstable(convergence.stable, bows_in_vertical_hole)?;
    Some(match convergence.rolls_at_md_m {
        Some(md_m) => check.at(md_m),
        None => check,
    })
}

/// Part of the drag by which the hook load of two meshes may differ: a tenth of what the friction
/// factor of a well is uncertain by.
const RESOLVED: f64 = 0.02;

/// Reports a helix whose hook load another mesh would change, or have none of.
pub(crate) fn helix(convergence: &Convergence, scalars: &Scalars) -> Option<Check> {
    let finer_N = convergence.finer_helix?.hook_load_N;
    let hook_load_N = scalars.hook_load_N;
    let most_N = RESOLVED * scalars.axial_friction_N.abs();
    let is_resolved = finer_N.is_some_and(|finer_N| (finer_N - hook_load_N).abs() <= most_N);
    let check = Check::reported(CheckKind::HelixNotResolved, Severity::Warning).value(hook_load_N);
    (!is_resolved).then(|| match finer_N {
        Some(finer_N) => check.limit(finer_N),
        None => check,
    })
}

/// Reports an equilibrium that a small disturbance would leave.
pub fn unstable(is_stable: bool, bows_in_vertical_hole: bool) -> Option<Check> {
    let severity = if bows_in_vertical_hole { Severity::Note } else { Severity::Warning };
    (!is_stable).then(|| Check::reported(CheckKind::UnstableEquilibrium, severity))
}

/// Reports a tool face that a bent string would leave without friction: the motion has no natural
/// frequency, and the numbers of the torsional modes begin after it.
pub fn unstable_tool_face(leaves: bool) -> Option<Check> {
    let check = Check::reported(CheckKind::UnstableEquilibrium, Severity::Warning);
    let sentence = "The tool face is not stable: without friction, weight and wall would turn the \
        bent assembly away from it. This torsional motion grows instead of vibrating and has no \
        frequency; torsional mode 1 is the lowest one that vibrates";
    leaves.then(|| check.worded(sentence.to_owned()))
}

/// Reports the penetration of the wall in static equilibrium, m, and its measured depth.
pub fn penetration_at_rest(model: &Model, [deepest_m, md_m]: [f64; 2]) -> Option<Check> {
    Some(penetration(mean_clearance_m(model), deepest_m)?.at(md_m))
}

/// Returns the checks of a run that was computed to its end.
pub fn checks(
    model: &Model,
    operation: &Operation,
    solution: &Solution<'_>,
    window: &Window<'_>,
) -> Vec<Check> {
    let numerics = window.run().numerics;
    let mut found = Vec::new();
    found.extend(penetration_in_time(model, numerics, operation.bit_depth_m));
    found.extend(element_buckles(numerics.buckled_element.as_ref()));
    found.extend(energy_residual(numerics.energy_residual));
    found.extend(window.run().bit_table.and_then(|table| bit_table(&table)));
    found.extend(unsettled(solution.profile));
    found.extend(bending_waves(solution.profile, window));
    found
}

/// Reports the penetration of the wall by the nodes that touch it. The bit does not: it is held to
/// the axis of the hole that it cuts by the lateral stiffness of its rock, and gives way by side
/// force over stiffness, whatever the law of the wall. Only a bit that leaves the axis by more than
/// the clearance of the string is reported.
fn penetration_in_time(model: &Model, numerics: &Numerics, bit_depth_m: f64) -> Option<Check> {
    let clearance_m = mean_clearance_m(model);
    let contact = numerics.deepest_contact;
    let contact = contact.map(|deepest| (deepest.penetration_m, deepest.md_m));
    let (deepest_m, md_m) = contact.unwrap_or((0.0, bit_depth_m));
    let bit_m = numerics.max_penetration_m;
    if bit_m > deepest_m && bit_m > THROUGH * clearance_m {
        return Some(penetration(clearance_m, bit_m)?.at(bit_depth_m));
    }
    Some(penetration(clearance_m, deepest_m)?.at(md_m))
}

fn penetration(clearance_m: f64, deepest_m: f64) -> Option<Check> {
    let limit = |part: f64| part * clearance_m;
    let (severity, limit_m) = if deepest_m > limit(THROUGH) {
        (Severity::Error, limit(THROUGH))
    } else if deepest_m > limit(DEEP) {
        (Severity::Warning, limit(DEEP))
    } else {
        return None;
    };
    Some(Check::reported(CheckKind::WallPenetration, severity).value(deepest_m).limit(limit_m))
}

/// Mean radial clearance, m, of the parts of the string that touch the wall.
fn mean_clearance_m(model: &Model) -> f64 {
    let length_m = model.string.length_m();
    let clearances = model.string.spans().map(|span| {
        let middle_m = length_m - 0.5 * (span.from_bit_m + span.to_bit_m);
        let hole_m = 0.5 * model.well.hole.at(middle_m).diameter_m;
        let clearance_m = hole_m - span.component.contact_radius_m();
        clearance_m.max(0.0) * span.component.length_m
    });
    clearances.sum::<f64>() / length_m
}

fn energy_residual(residual: f64) -> Option<Check> {
    let size = residual.abs();
    // A run whose energy is no longer a number has lost all of it.
    let (severity, limit) = if size <= RESIDUAL {
        return None;
    } else if size <= LOST {
        (Severity::Warning, RESIDUAL)
    } else {
        (Severity::Error, LOST)
    };
    Some(Check::reported(CheckKind::EnergyResidual, severity).value(residual).limit(limit))
}

fn bit_table(table: &TableUse) -> Option<Check> {
    (table.outside_fraction > 0.0).then(|| {
        Check::reported(CheckKind::BitTableLeft, Severity::Warning)
            .value(table.outside_fraction)
            .limit(0.0)
    })
}

/// Reports the element that buckles most between its nodes: the string folds there as no pipe does.
pub fn element_buckles(element: Option<&BuckledElement>) -> Option<Check> {
    element.map(|element| {
        Check::reported(CheckKind::ElementBuckles, Severity::Error)
            .at(element.md_m)
            .value(element.compression_N)
            .limit(element.own_load_N)
    })
}

/// Reports a shaken string in which most elements reach from one contact to the next.
fn bending_waves(profile: &Profile, window: &Window<'_>) -> Option<Check> {
    let weight = window.statistic("weight_on_bit_N")?;
    let friction = window.statistic("friction_torque_N_m")?;
    let reasons = &profile.element_size;
    let long =
        |reason: &&SizeReason| matches!(reason, SizeReason::JointToJoint | SizeReason::PlainPipe);
    let most = 2 * reasons.iter().filter(long).count() > reasons.len();
    (most && weight.std > SHAKEN * weight.mean.abs() && friction.mean != 0.0).then(|| {
        Check::reported(CheckKind::BendingWavesLeftOut, Severity::Note).value(friction.std)
    })
}

/// The node that is most restless against its neighbours.
fn unsettled(nodes: &Profile) -> Option<Check> {
    let Profile { md_m, tension_N, tension_std_N: std_N, .. } = nodes;
    let largest_N = tension_N.iter().fold(0.0, |largest: f64, t| largest.max(t.abs()));
    let mut near: Vec<f64> = Vec::new();
    let mut worst: Option<(f64, Check)> = None;
    for (i, std) in std_N.iter().enumerate() {
        if *std <= SWINGS * largest_N {
            continue;
        }
        let from = md_m.partition_point(|md| *md < md_m[i] - NEIGHBOURS_M);
        let to = md_m.partition_point(|md| *md <= md_m[i] + NEIGHBOURS_M);
        near.clear();
        near.extend_from_slice(std_N.get(from..to).unwrap_or_default());
        near.sort_by(f64::total_cmp);
        let Some(median_N) = near.get(near.len() / 2) else {
            continue;
        };
        let expected_N = (RESTLESS * median_N).max(SWINGS * largest_N);
        let over = std / expected_N;
        if over > 1.0 && worst.as_ref().is_none_or(|(most, _)| over > *most) {
            let found = Check::reported(CheckKind::NodeUnsettled, Severity::Warning)
                .at(md_m[i])
                .value(*std)
                .limit(expected_N);
            worst = Some((over, found));
        }
    }
    worst.map(|(_, found)| found)
}
