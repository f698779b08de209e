//! What a calibration looks for.

use wholestring::{operation::OperationKind, well::HoleKind};
use wholestring_case::Case;
use wholestring_plan::calibration::{
    AroundRatio, Factors, HolePart, MOST_SECTIONS, Parameter, Settings, State,
};

use super::fit::Fit;
use crate::{
    error::Error,
    readings::{NamedCase, Readings},
};

/// What is looked for, by what the readings reach and what the cases give.
pub(super) fn settings(
    fit: &Fit,
    cases: &[NamedCase<'_>],
    data: &Readings,
) -> Result<Settings, Error> {
    let case = cases[0].case;
    let reaches = |part: HolePart| {
        let mut readings = data.readings.iter();
        readings.any(|of| data.assemblies[of.setup].reaches(of.bit_depth_m, part))
    };
    let turns = data.readings.iter().any(|of| of.channel.is_torque());
    let (cased, open) = (reaches(HoleKind::Casing.into()), reaches(HoleKind::Open.into()));
    let mut parameters = match (fit.one_factor, cased, open) {
        _ if fit.by_section => {
            let count = sections(cases)?;
            let reached = (0..count).filter(|of| reaches(HolePart::Section(*of)));
            reached.map(Parameter::Section).collect()
        }
        (false, true, true) => vec![Parameter::Cased, Parameter::Open],
        _ => vec![Parameter::Friction],
    };
    if fit.friction_around {
        if !turns {
            let reason = "rotational friction is looked for, but no torque was read";
            return Err(Error::BadInput(reason.into()));
        }
        let around = |of: &Parameter| match of {
            Parameter::Cased => Parameter::CasedAround,
            Parameter::Open => Parameter::OpenAround,
            Parameter::Section(of) => Parameter::SectionAround(*of),
            _ => Parameter::FrictionAround,
        };
        parameters.extend(parameters.iter().map(around).collect::<Vec<_>>());
    }
    let weighs = data.readings.iter().any(|of| !of.channel.is_torque());
    let known = case.model.rig.block_weight_N;
    if weighs && (fit.block_weight || known.is_none()) {
        parameters.push(Parameter::BlockWeight);
    }
    if fit.bit_torque {
        parameters.push(Parameter::BitTorque);
    }
    let drills = case.operations.iter().find(|of| of.kind == OperationKind::Drill);
    let [along, around] = frictions(case);
    // What no reading reaches stays as the case has it.
    let mut own = [None; MOST_SECTIONS];
    if fit.by_section {
        for (own, section) in own.iter_mut().zip(case.model.well.hole.sections()) {
            let friction = section.friction;
            *own = Some([friction.kinetic, friction.kinetic * friction.around]);
        }
    }
    let mut settings = Settings::new(
        parameters,
        State {
            factors: Factors {
                cased: along[0],
                open: along[1],
                cased_around: around[0],
                open_around: around[1],
                sections: own,
            },
            block_weight_N: known.unwrap_or(0.0),
            bit_torque_N_m: drills.map_or(0.0, |of| of.bit_torque_N_m),
        },
    );
    let ratio = |[along, around]: [f64; 2]| if along > 0.0 { around / along } else { 1.0 };
    settings.around_ratio = AroundRatio {
        walls: [0, 1].map(|wall| ratio([along[wall], around[wall]])),
        sections: own.map(|of| of.map_or(1.0, ratio)),
    };
    for (parameter, value) in &fit.hold {
        if !settings.parameters.contains(parameter) {
            let names = settings.parameters.iter().map(|of| of.name()).collect::<Vec<_>>();
            return Err(Error::BadInput(format!(
                "{} is not looked for and cannot be held: looked for are {}",
                parameter.name(),
                names.join(", ")
            )));
        }
        settings.hold(*parameter, *value);
    }
    settings.errors = fit.errors;
    settings.outlier_beyond = fit.outlier_beyond;
    settings.band_confidence = fit.band_confidence;
    Ok(settings)
}

/// How many sections the hole of these cases has: all have the same ones.
fn sections(cases: &[NamedCase<'_>]) -> Result<usize, Error> {
    let hole = |of: &NamedCase<'_>| {
        let sections = of.case.model.well.hole.sections().iter();
        sections.map(|section| (section.kind, section.to_md_m)).collect::<Vec<_>>()
    };
    let first = hole(&cases[0]);
    // Of the last one the depth is that of the day.
    let above = |of: &[(HoleKind, f64)]| of[..of.len() - 1].to_vec();
    for other in &cases[1..] {
        let sections = hole(other);
        if sections.len() != first.len() || above(&sections) != above(&first) {
            return Err(Error::BadInput(format!(
                "a factor for each section: '{}' and '{}' have other sections in their holes",
                cases[0].case.name, other.case.name
            )));
        }
    }
    match first.len() <= MOST_SECTIONS {
        true => Ok(first.len()),
        false => Err(Error::BadInput(format!(
            "a factor for each section: the hole has {}, {MOST_SECTIONS} are the most that are told \
             apart: join some that are alike in the case",
            first.len()
        ))),
    }
}

/// Factors of a case along and around the hole: of its deepest casing and its deepest open hole.
fn frictions(case: &Case) -> [[f64; 2]; 2] {
    let of = |kind: HoleKind| {
        let mut sections = case.model.well.hole.sections().iter().rev();
        let friction = sections.find(|section| section.kind == kind).map(|of| of.friction);
        friction.map_or([0.0, 0.0], |of| [of.kinetic, of.kinetic * of.around])
    };
    let (cased, open) = (of(HoleKind::Casing), of(HoleKind::Open));
    [[cased[0], open[0]], [cased[1], open[1]]]
}
