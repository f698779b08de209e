//! Results in the form of the tables.

use std::collections::BTreeSet;

use wholestring::{outcome::ModelKind, well::HoleKind};
use wholestring_judge::{Check, Judge, Unchecked};
use wholestring_plan::{Broomstick, BroomstickPoint, BucklingWeight, FrictionLevel};
use wholestring_results::{PlanBuckling, PlanCheck, PlanFriction, PlanOperation, PlanPoint};
use wholestring_units::significant;

pub(super) fn points(found: &[BroomstickPoint]) -> Vec<PlanPoint> {
    let point = |point: &BroomstickPoint| {
        let answer = point.outcome.as_ref().ok();
        PlanPoint {
            model: point.model.kind(),
            friction: point.friction,
            operation: point.operation,
            bit_depth_m: point.bit_depth_m,
            scalars: answer.map(|answer| answer.scalars),
            buckling: answer.map(|answer| answer.buckling.name().to_owned()),
            worst: point.checks.most_severe().cloned(),
            message: match answer {
                Some(_) => None,
                None => point.checks.most_severe().map(|check| check.sentence.clone()),
            },
        }
    };
    found.iter().map(point).collect()
}

/// Checks at these points.
pub(super) fn checks(found: &[BroomstickPoint]) -> Vec<PlanCheck> {
    let rows = |point: &BroomstickPoint| {
        let row = |check: &Check| PlanCheck {
            model: point.model.kind(),
            friction: point.friction,
            operation: PlanOperation::Kind(point.operation),
            bit_depth_m: point.bit_depth_m,
            check: check.clone(),
        };
        point.checks.checks.iter().map(row).collect::<Vec<_>>()
    };
    found.iter().flat_map(rows).collect()
}

/// Checks that were not possible at these points.
pub(super) fn unchecked(found: &[BroomstickPoint]) -> BTreeSet<Unchecked> {
    found.iter().flat_map(|point| point.checks.unchecked.iter().cloned()).collect()
}

pub(super) fn buckling(found: &[BucklingWeight], judge: &Judge) -> Vec<PlanBuckling> {
    let row = |weight: &BucklingWeight| {
        let [sinusoidal, helical] = weight.weights_N.as_ref().map_or([None; 2], |weights| *weights);
        PlanBuckling {
            model: ModelKind::Soft,
            friction: weight.friction,
            operation: weight.operation,
            bit_depth_m: weight.bit_depth_m,
            sinusoidal_weight_N: sinusoidal,
            helical_weight_N: helical,
            message: weight.weights_N.as_ref().err().map(|why| judge.reason(why)),
        }
    };
    found.iter().map(row).collect()
}

/// Friction of each section at each level.
pub(super) fn frictions(broomstick: &Broomstick) -> Vec<PlanFriction> {
    let sections = |level: FrictionLevel| {
        let sections = broomstick.setup(level).well.hole.sections().iter();
        sections.map(move |section| PlanFriction {
            friction: level,
            kind: match section.kind {
                HoleKind::Casing => "casing".to_owned(),
                HoleKind::Open => "open".to_owned(),
            },
            from_md_m: section.from_md_m,
            to_md_m: section.to_md_m,
            // Removes digits left by rounding.
            along: significant(section.friction.kinetic, DIGITS),
            around: significant(section.friction.kinetic * section.friction.around, DIGITS),
        })
    };
    FrictionLevel::ALL.into_iter().flat_map(sections).collect()
}

/// Digits of a coefficient of friction.
const DIGITS: usize = 12;
