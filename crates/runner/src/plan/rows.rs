//! What was found as results have it.

use wholestring::well::HoleKind;
use wholestring_plan::{Broomstick, BroomstickPoint, BucklingWeight, FrictionLevel};
use wholestring_results::{PlanBuckling, PlanFinding, PlanFriction, PlanPoint};

pub(super) fn points(found: &[BroomstickPoint]) -> Vec<PlanPoint> {
    let point = |of: &BroomstickPoint| {
        let answer = of.outcome.as_ref().ok();
        let worst = answer.and_then(|answer| answer.findings.first());
        PlanPoint {
            model: of.model.name().to_owned(),
            friction: of.friction.name().to_owned(),
            operation: of.operation.name().to_owned(),
            bit_depth_m: of.bit_depth_m,
            scalars: answer.map(|answer| answer.scalars),
            buckling: answer.map(|answer| answer.buckling.name().to_owned()),
            worst: worst.map(|finding| PlanFinding {
                kind: finding.kind.name().to_owned(),
                level: finding.level,
                md_m: finding.from_md_m,
                value: finding.value,
                limit: finding.limit,
            }),
            message: of.outcome.as_ref().err().map(ToString::to_string),
        }
    };
    found.iter().map(point).collect()
}

pub(super) fn buckling(found: &[BucklingWeight]) -> Vec<PlanBuckling> {
    let row = |of: &BucklingWeight| {
        let [sinusoidal, helical] = of.weights_N.as_ref().map_or([None; 2], |weights| *weights);
        PlanBuckling {
            model: "soft".to_owned(),
            friction: of.friction.name().to_owned(),
            operation: of.operation.name().to_owned(),
            bit_depth_m: of.bit_depth_m,
            sinusoidal_weight_N: sinusoidal,
            helical_weight_N: helical,
            message: of.weights_N.as_ref().err().map(ToString::to_string),
        }
    };
    found.iter().map(row).collect()
}

/// Friction of each section at each level.
pub(super) fn frictions(of: &Broomstick) -> Vec<PlanFriction> {
    let sections = |level: FrictionLevel| {
        let sections = of.setup(level).well.hole.sections().iter();
        sections.map(move |section| PlanFriction {
            friction: level.name().to_owned(),
            kind: match section.kind {
                HoleKind::Casing => "casing".to_owned(),
                HoleKind::Open => "open".to_owned(),
            },
            from_md_m: section.from_md_m,
            to_md_m: section.to_md_m,
            // Of what rounding leaves, nothing.
            along: rounded(section.friction.kinetic),
            around: rounded(section.friction.kinetic * section.friction.around),
        })
    };
    FrictionLevel::ALL.into_iter().flat_map(sections).collect()
}

fn rounded(value: f64) -> f64 {
    (1e12 * value).round() * 1e-12
}
