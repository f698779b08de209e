//! Parameters of a calibration.

use wholestring::{operation::OperationKind, well::HoleKind};
use wholestring_case::Case;
use wholestring_plan::calibration::{
    AroundRatio, Factors, HolePart, MOST_SECTIONS, Parameter, Settings, State,
};

use super::option::{self, Fit};
use crate::{
    error::Error,
    readings::{NamedCase, Readings},
};

/// Selects the parameters to fit by the sections that the readings reach and the values that the
/// cases give.
pub(super) fn settings(
    fit: &Fit,
    cases: &[NamedCase<'_>],
    data: &Readings,
) -> Result<Settings, Error> {
    let case = cases[0].case;
    let reaches = |part: HolePart| {
        let mut readings = data.readings.iter();
        readings.any(|reading| data.assemblies[reading.setup].reaches(reading.bit_depth_m, part))
    };
    let turns = data.readings.iter().any(|reading| reading.channel.is_torque());
    let (cased, open) = (reaches(HoleKind::Casing.into()), reaches(HoleKind::Open.into()));
    let mut parameters = match (fit.one_factor, cased, open) {
        _ if fit.by_section => {
            let count = sections(cases)?;
            let reached = (0..count).filter(|section| reaches(HolePart::Section(*section)));
            reached.map(Parameter::Section).collect()
        }
        (false, true, true) => vec![Parameter::Cased, Parameter::Open],
        _ => vec![Parameter::Friction],
    };
    if fit.friction_around {
        if !turns {
            let reason = "rotational friction is to be fitted, but there is no torque reading";
            return Err(Error::BadInput(reason.into()));
        }
        let around = |parameter: &Parameter| match parameter {
            Parameter::Cased => Parameter::CasedAround,
            Parameter::Open => Parameter::OpenAround,
            Parameter::Section(section) => Parameter::SectionAround(*section),
            _ => Parameter::FrictionAround,
        };
        parameters.extend(parameters.iter().map(around).collect::<Vec<_>>());
    }
    let weighs = data.readings.iter().any(|reading| !reading.channel.is_torque());
    if weighs && (fit.block_weight || case.model.rig.block_weight_N.is_none()) {
        parameters.push(Parameter::BlockWeight);
    }
    if fit.bit_torque {
        parameters.push(Parameter::BitTorque);
    }
    let [along, around] = frictions(case);
    // Sections that no reading reaches keep the value of the case.
    let mut own = [None; MOST_SECTIONS];
    if fit.by_section {
        for (own, section) in own.iter_mut().zip(case.model.well.hole.sections()) {
            let friction = section.friction;
            *own = Some([friction.kinetic, friction.kinetic * friction.around]);
        }
    }
    let mut held = of_case(case);
    held.factors.sections = own;
    let mut settings = Settings::new(parameters, held);
    let ratio = |[along, around]: [f64; 2]| if along > 0.0 { around / along } else { 1.0 };
    settings.around_ratio = AroundRatio {
        walls: [0, 1].map(|wall| ratio([along[wall], around[wall]])),
        sections: own.map(|factors| factors.map_or(1.0, ratio)),
    };
    for (parameter, value) in &fit.hold {
        if !settings.parameters.contains(parameter) {
            let names =
                settings.parameters.iter().map(|other| option::name(*other)).collect::<Vec<_>>();
            return Err(Error::BadInput(format!(
                "{} is not a parameter of this fit and cannot be kept fixed; its parameters are {}",
                option::name(*parameter),
                names.join(", ")
            )));
        }
        option::in_range(*parameter, *value).map_err(|expected| {
            Error::BadInput(format!(
                "{} = {value} cannot be kept fixed: {expected}",
                option::name(*parameter)
            ))
        })?;
        settings.hold(*parameter, *value);
    }
    settings.errors = fit.errors;
    settings.outlier_beyond = fit.outlier_beyond;
    settings.band_confidence = fit.band_confidence;
    Ok(settings)
}

/// Settings with which readings are compared and no friction is fitted: only a block weight that
/// the case does not give is free.
pub(super) fn of_comparison(case: &Case) -> Settings {
    let is_free = case.model.rig.block_weight_N.is_none();
    let parameters = is_free.then_some(Parameter::BlockWeight).into_iter().collect();
    Settings::new(parameters, of_case(case))
}

/// Friction of casing and open hole, block weight and torque on bit as the case gives them.
fn of_case(case: &Case) -> State {
    let drills = case.operations.iter().find(|operation| operation.kind == OperationKind::Drill);
    let [along, around] = frictions(case);
    State {
        factors: Factors {
            cased: along[0],
            open: along[1],
            cased_around: around[0],
            open_around: around[1],
            sections: [None; MOST_SECTIONS],
        },
        block_weight_N: case.model.rig.block_weight_N.unwrap_or(0.0),
        bit_torque_N_m: drills.map_or(0.0, |drill| drill.bit_torque_N_m),
    }
}

/// Number of sections of the hole, which is the same in all cases.
fn sections(cases: &[NamedCase<'_>]) -> Result<usize, Error> {
    let hole = |case: &NamedCase<'_>| {
        let sections = case.case.model.well.hole.sections().iter();
        sections.map(|section| (section.kind, section.to_md_m)).collect::<Vec<_>>()
    };
    let first = hole(&cases[0]);
    // The depth of the last section is that of the day.
    let above = |kinds: &[(HoleKind, f64)]| kinds[..kinds.len() - 1].to_vec();
    for other in &cases[1..] {
        let sections = hole(other);
        if sections.len() != first.len() || above(&sections) != above(&first) {
            return Err(Error::BadInput(format!(
                "a factor for each section: '{}' and '{}' have different hole sections",
                cases[0].case.name, other.case.name
            )));
        }
    }
    match first.len() <= MOST_SECTIONS {
        true => Ok(first.len()),
        false => Err(Error::BadInput(format!(
            "a factor for each section: the hole has {} sections, but at most {MOST_SECTIONS} can \
             be fitted: join similar sections in the case",
            first.len()
        ))),
    }
}

/// Axial and rotational friction factors of a case: of its deepest casing and its deepest open
/// hole.
fn frictions(case: &Case) -> [[f64; 2]; 2] {
    let friction_in = |kind: HoleKind| {
        let mut sections = case.model.well.hole.sections().iter().rev();
        let friction =
            sections.find(|section| section.kind == kind).map(|section| section.friction);
        friction
            .map_or([0.0, 0.0], |friction| [friction.kinetic, friction.kinetic * friction.around])
    };
    let (cased, open) = (friction_in(HoleKind::Casing), friction_in(HoleKind::Open));
    [[cased[0], open[0]], [cased[1], open[1]]]
}
