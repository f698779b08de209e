//! What was found as results have it.

use std::collections::BTreeSet;

use wholestring::{string::ComponentSpec, well::HoleKind};
use wholestring_plan::{
    Broomstick, BroomstickPoint, BucklingWeight, FrictionLevel, limits::LoadCheck,
};
use wholestring_results::{PlanBuckling, PlanFinding, PlanFriction, PlanLimit, PlanPoint};

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

/// What pipe and rig bear at these points.
pub(super) fn limits(of: &Broomstick, found: &[BroomstickPoint]) -> Vec<PlanLimit> {
    let mut rows = Vec::new();
    for point in found {
        let Ok(answer) = &point.outcome else { continue };
        let components = &of.setup(point.friction).string.components;
        rows.extend(answer.limits.limits.iter().map(|found| PlanLimit {
            model: point.model.name().to_owned(),
            friction: point.friction.name().to_owned(),
            operation: point.operation.name().to_owned(),
            bit_depth_m: point.bit_depth_m,
            ..limit(components, found)
        }));
    }
    rows
}

/// A limit of a string of these components, of nobody yet.
pub(super) fn limit(components: &[ComponentSpec], limit: &LoadCheck) -> PlanLimit {
    PlanLimit {
        model: String::new(),
        friction: String::new(),
        operation: String::new(),
        bit_depth_m: f64::NAN,
        kind: limit.kind.name().to_owned(),
        component: limit.component.and_then(|at| Some(components.get(at)?.name.clone())),
        md_m: limit.md_m,
        load: limit.load,
        capacity: limit.capacity,
        unit: limit.kind.quantity().unit().to_owned(),
        factor: limit.factor,
        required: limit.required,
        standing: limit.level.name().to_owned(),
    }
}

/// What is missing, and of which component; empty of the rig.
pub(super) type Lack = (String, String);

/// What could not be checked at these points.
pub(super) fn unchecked(of: &Broomstick, found: &[BroomstickPoint]) -> BTreeSet<Lack> {
    let mut lacking = BTreeSet::new();
    for point in found {
        let Ok(answer) = &point.outcome else { continue };
        let components = &of.setup(point.friction).string.components;
        for one in &answer.limits.unchecked {
            let component = one.component.and_then(|at| components.get(at));
            let name = component.map_or_else(String::new, |of| of.name.clone());
            lacking.insert((one.missing.words().to_owned(), name));
        }
    }
    lacking
}

/// The same in words: `no yield strength of jar, motor`.
pub(super) fn in_words(lacking: &BTreeSet<Lack>) -> Vec<String> {
    let mut words: Vec<(String, Vec<String>)> = Vec::new();
    for (missing, component) in lacking {
        if words.last().is_none_or(|(last, _)| last != missing) {
            words.push((missing.clone(), Vec::new()));
        }
        if let (Some((_, components)), false) = (words.last_mut(), component.is_empty()) {
            components.push(component.clone());
        }
    }
    let said = |(missing, components): (String, Vec<String>)| match components.is_empty() {
        true => missing,
        false => format!("{missing} of {}", components.join(", ")),
    };
    words.into_iter().map(said).collect()
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
