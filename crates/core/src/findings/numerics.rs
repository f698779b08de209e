//! How far the numbers of a dynamic run can be trusted.

use super::{Finding, Kind, Level};
use crate::{
    dynamics::{DynamicOutcome, TableUse},
    model::Model,
    outcome::Profile,
    rod::buckled_element::BuckledElement,
    sizing::SizeReason,
    statics::stiff::{Convergence, StiffError},
};

/// Parts of the string's mean clearance. A wall is to hold a pipe at the clearance that the hole
/// leaves it: a tenth more moves the pipe as far as hole sizes are known; as much again, and it is
/// another hole.
const DEEP: f64 = 0.1;
const THROUGH: f64 = 1.0;

/// Energy that the integration gained or lost: as much as torque and drag of a good model and a rig
/// differ by, ...
const RESIDUAL: f64 = 0.05;

/// ... and so much that friction, of which torque and drag are made, is no longer what was
/// computed.
const LOST: f64 = 0.2;

/// A node whose tension varies by this many times as much as that of the median of its neighbours,
/// ...
const RESTLESS: f64 = 10.0;

/// ... within this distance, m, ...
const NEIGHBOURS_M: f64 = 100.0;

/// ... and by more than this part of the largest tension or compression, never settled.
const SWINGS: f64 = 0.02;

/// A bit whose weight varies by more than this part of its mean shakes the string.
const SHAKEN: f64 = 0.02;

/// Of an equilibrium: whether it would stay as it is; and where the string would roll around its hole
/// instead, for ever.
pub fn equilibrium(of: &Convergence) -> Option<Finding> {
    let found = (!of.stable).then(|| Finding::new(Kind::UnstableEquilibrium, Level::Warning))?;
    Some(match of.rolls_at_md_m {
        Some(md_m) => found.at(md_m),
        None => found,
    })
}

/// Of an operation without one: where it locks up, or where forces are farthest out of balance.
pub fn no_equilibrium(error: &StiffError) -> Option<Finding> {
    let found = Finding::new(Kind::NoEquilibrium, Level::Error);
    match *error {
        StiffError::Soft(_) => None,
        StiffError::LocksUp { md_m }
        | StiffError::RunsAway { md_m, .. }
        | StiffError::Rolls { md_m, .. }
        | StiffError::ElementBuckles { md_m, .. } => Some(found.at(md_m)),
        StiffError::ThroughWall { md_m, penetration_m, clearance_m } => Some(
            Finding::new(Kind::WallPenetration, Level::Error)
                .at(md_m)
                .value(penetration_m)
                .limit(clearance_m),
        ),
        StiffError::NotConverged { md_m, residual_N, .. } => {
            Some(found.at(md_m).value(residual_N).limit(0.0))
        }
    }
}

/// Of an equilibrium: how far the wall gives way, m, and at which measured depth.
pub fn penetration_at_rest(model: &Model, [deepest_m, md_m]: [f64; 2]) -> Option<Finding> {
    Some(penetration(mean_clearance_m(model), deepest_m)?.at(md_m))
}

/// Of a run that was computed to its end.
pub fn findings(model: &Model, outcome: &DynamicOutcome) -> Vec<Finding> {
    let of = &outcome.numerics;
    let mut found = Vec::new();
    found.extend(penetration(mean_clearance_m(model), of.max_penetration_m));
    found.extend(element_buckles(of.buckled_element.as_ref()));
    found.extend(energy_residual(of.energy_residual));
    found.extend(outcome.bit_table.and_then(|of| bit_table(&of)));
    found.extend(unsettled(&outcome.nodes));
    found.extend(bending_waves(outcome));
    found
}

fn penetration(clearance_m: f64, deepest_m: f64) -> Option<Finding> {
    let limit = |part: f64| part * clearance_m;
    let (level, limit_m) = if deepest_m > limit(THROUGH) {
        (Level::Error, limit(THROUGH))
    } else if deepest_m > limit(DEEP) {
        (Level::Warning, limit(DEEP))
    } else {
        return None;
    };
    Some(Finding::new(Kind::WallPenetration, level).value(deepest_m).limit(limit_m))
}

/// Mean radial clearance along the string, of what touches the wall, m.
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

fn energy_residual(residual: f64) -> Option<Finding> {
    let size = residual.abs();
    // A run that is not a number any more has lost all of it.
    let (level, limit) = if size <= RESIDUAL {
        return None;
    } else if size <= LOST {
        (Level::Warning, RESIDUAL)
    } else {
        (Level::Error, LOST)
    };
    Some(Finding::new(Kind::EnergyResidual, level).value(residual).limit(limit))
}

fn bit_table(of: &TableUse) -> Option<Finding> {
    (of.outside_fraction > 0.0).then(|| {
        Finding::new(Kind::BitTableLeft, Level::Warning).value(of.outside_fraction).limit(0.0)
    })
}

/// The element that buckles most between its nodes: the string folds there as no pipe does.
pub fn element_buckles(element: Option<&BuckledElement>) -> Option<Finding> {
    element.map(|element| {
        Finding::new(Kind::ElementBuckles, Level::Error)
            .at(element.md_m)
            .value(element.compression_N)
            .limit(element.own_load_N)
    })
}

/// A shaken string of which most elements reach from one contact to the next.
fn bending_waves(outcome: &DynamicOutcome) -> Option<Finding> {
    let weight = outcome.statistic("weight_on_bit_N")?;
    let friction = outcome.statistic("friction_torque_N_m")?;
    let reasons = &outcome.nodes.element_size;
    let long = |of: &&SizeReason| matches!(of, SizeReason::JointToJoint | SizeReason::PlainPipe);
    let most = 2 * reasons.iter().filter(long).count() > reasons.len();
    (most && weight.std > SHAKEN * weight.mean.abs() && friction.mean != 0.0)
        .then(|| Finding::new(Kind::BendingWavesLeftOut, Level::Note).value(friction.std))
}

/// The node that is most restless against its neighbours.
fn unsettled(nodes: &Profile) -> Option<Finding> {
    let Profile { md_m, tension_N, tension_std_N: std_N, .. } = nodes;
    let largest_N = tension_N.iter().fold(0.0, |of: f64, t| of.max(t.abs()));
    let mut near: Vec<f64> = Vec::new();
    let mut worst: Option<(f64, Finding)> = None;
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
            let found = Finding::new(Kind::NodeUnsettled, Level::Warning)
                .at(md_m[i])
                .value(*std)
                .limit(expected_N);
            worst = Some((over, found));
        }
    }
    worst.map(|(_, found)| found)
}
