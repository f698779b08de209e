//! `[plan.campaign]` and `[plan.fatigue]`: effects of all operations together on string and casing.

use wholestring::{
    string::StringSpec,
    well::{Hole, HoleKind},
};
use wholestring_config::prelude::*;
use wholestring_plan::{
    CampaignSettings, Setup,
    fatigue::{FatigueSettings, SnCurve},
    wear::WearFactors,
};

/// The unit of wear factors, 1/Pa.
const UNIT_PER_PA: f64 = 1e-10 / 6_894.757_293_168_361;

/// Maximum number of wear factors.
const MAX_CASINGS: usize = 20;

table! {
    /// The campaign over which casing wear and fatigue are summed, with the expected friction.
    CampaignTable in "[plan.campaign]" {
        /// Measured depth from which the section is drilled, to the deepest of the plan. Default:
        /// the deepest casing shoe.
        drilled_from: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0).usual(10.0, 13_000.0),
            "1500 m",
        ));
        /// Number of times that the string is run and pulled, whether or not the plan lists trips.
        round_trips: f64 = default(Number::up_to(1000.0), CampaignSettings::default().round_trips);
        /// Duration of rotation off bottom at the deepest depth, s unless a unit is given, whether
        /// or not the plan lists that operation.
        off_bottom: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(0.0, 1e8).usual(60.0, 1e7), "10 h"),
            0.0,
        );
        /// Wear factor of the casings, in 1e-10 1/psi. One for all of them or a list, from the
        /// surface down. Default: 5, only a first estimate.
        wear_factor: Vec<Spanned<f64>> = optional(List::or_one(
            Number { unit: "1e-10/psi", range: Range::positive_to(1e4).usual(0.3, 50.0) },
            "wear factors",
            MAX_CASINGS,
        ));
    }
}

table! {
    /// Fatigue of the string in doglegs: the S-N curve N = cycles (stress/S)^exponent. Default:
    /// curve B1 in air of DNV-RP-C203.
    FatigueTable in "[plan.fatigue]" {
        /// Cycles to failure at `stress`; requires `stress` and `exponent`.
        cycles: f64 = optional(Number { unit: "", range: Range::from_to(1.0, 1e12) });
        /// Stress amplitude at which the pipe fails after that number of cycles: half of the stress
        /// range.
        stress: f64 = optional(stress("138 MPa"));
        /// Exponent of the curve above `stress`.
        exponent: f64 = optional(Number { unit: "", range: Range::from_to(1.0, 50.0) });
        /// Exponent below `stress`. Default: `exponent`.
        exponent_below: f64 = optional(Number { unit: "", range: Range::from_to(1.0, 50.0) });
        /// Amplitude below which there is no damage. Default: none.
        endurance_limit: f64 = optional(stress("60 MPa"));
        /// Tensile strength of all pipe. Default: by its grade, else its yield strength.
        tensile_strength: f64 = optional(stress("1000 MPa"));
    }
}

fn stress(example: &'static str) -> Quantity {
    let range = Range::from_to(1e6, 1e10).usual(1e7, 2e9);
    Quantity::si(Dimension::Stress, range, example)
}

/// Builds the campaign, of a string in its hole with the bit at a deepest depth, m.
pub(crate) fn build(
    campaign: Option<&CampaignTable>,
    fatigue: Option<&FatigueTable>,
    setup: &Setup,
    deepest_m: f64,
    reader: &mut Reader,
) -> Option<CampaignSettings> {
    let fatigue = match fatigue {
        Some(table) => fatigue_of(table, &setup.string, reader)?,
        None => FatigueSettings::default(),
    };
    let Some(table) = campaign else {
        return Some(CampaignSettings { fatigue, ..CampaignSettings::default() });
    };
    let drilled_from = table.drilled_from.optional()?;
    if let Some(from) = drilled_from
        && from.value >= deepest_m
    {
        return Diagnostic::error("the section is drilled from no shallower than its end")
            .at(
                from.place,
                format!(
                    "the deepest bit of the plan is at {}",
                    reader.shown(Dimension::Length, deepest_m)
                ),
            )
            .refuse(reader);
    }
    Some(CampaignSettings {
        drilled_from_m: drilled_from.map(|at| at.value),
        round_trips: *table.round_trips.get()?,
        off_bottom_s: *table.off_bottom.get()?,
        operations: Vec::new(),
        fatigue,
        wear_factors: wear_factors(table, &setup.well.hole, reader)?,
    })
}

fn wear_factors(table: &CampaignTable, hole: &Hole, reader: &mut Reader) -> Option<WearFactors> {
    let Some(Spanned { value: factors, place }) = table.wear_factor.optional()? else {
        return Some(WearFactors::default());
    };
    let cased =
        hole.sections().iter().enumerate().filter(|(_, section)| section.kind == HoleKind::Casing);
    let cased: Vec<usize> = cased.map(|(index, _)| index).collect();
    if let [one] = &factors[..] {
        if cased.is_empty() {
            reader.report(Diagnostic::idle("wear_factor", *place, "the hole has no casing"));
        }
        let usual_per_Pa = one.value * UNIT_PER_PA;
        return Some(WearFactors { usual_per_Pa, of_section_per_Pa: Vec::new() });
    }
    if factors.len() != cased.len() {
        let count = match cased.len() {
            1 => "the hole has one cased section".to_owned(),
            count => format!("the hole has {count} cased sections"),
        };
        return Diagnostic::error(format!("{} wear factors are listed", factors.len()))
            .at(*place, format!("{count}: one for each, or one for all"))
            .refuse(reader);
    }
    let of_section = |(index, at): (usize, &Spanned<f64>)| (index, at.value * UNIT_PER_PA);
    Some(WearFactors {
        of_section_per_Pa: cased.into_iter().zip(factors).map(of_section).collect(),
        ..WearFactors::default()
    })
}

fn fatigue_of(
    table: &FatigueTable,
    string: &StringSpec,
    reader: &mut Reader,
) -> Option<FatigueSettings> {
    let [cycles, stress, exponent] =
        [&table.cycles, &table.stress, &table.exponent].map(|field| field.optional());
    let numbers = [("cycles", cycles?), ("stress", stress?), ("exponent", exponent?)];
    let below = table.exponent_below.optional()?;
    let endured = table.endurance_limit.optional()?;
    let tensile = table.tensile_strength.optional()?;
    if let Some(tensile) = tensile {
        bears(tensile, endured, "the endurance limit", reader)?;
        bears(tensile, stress?, "the stress of the S-N curve", reader)?;
        yields(tensile, string, reader)?;
    }
    if let (Some(below), Some(exponent)) = (below, exponent?)
        && below.value < exponent.value
    {
        let warning = Diagnostic::warning("the S-N curve is steeper below its stress than above");
        reader.report(
            warning
                .at(below.place, format!("less than `exponent`, {}", number_text(exponent.value)))
                .help(
                    "small stresses then damage more than the upper slope gives; usually it is \
                     greater",
                ),
        );
    }
    let sn_curve = match numbers.map(|(_, number)| number) {
        [Some(cycles), Some(stress), Some(exponent)] => SnCurve {
            exponent_below: below.map_or(exponent.value, |at| at.value),
            ..SnCurve::of_one_slope(cycles.value, stress.value, exponent.value)
        },
        [None, None, None] => {
            if let Some(below) = below {
                let why = "it belongs to `cycles`, `stress` and `exponent`";
                reader.report(Diagnostic::idle("exponent_below", below.place, why));
            }
            SnCurve::default()
        }
        some => {
            let missing = numbers.iter().filter(|(_, number)| number.is_none());
            let missing: Vec<String> = missing.map(|(name, _)| format!("`{name}`")).collect();
            let place = some.into_iter().flatten().next()?.place;
            return Diagnostic::error("an S-N curve needs `cycles`, `stress` and `exponent`")
                .at(place, format!("without {}", missing.join(" and ")))
                .refuse(reader);
        }
    };
    Some(FatigueSettings {
        sn_curve: SnCurve { endurance_limit_Pa: endured.map(|at| at.value), ..sn_curve },
        tensile_strength_Pa: tensile.map(|at| at.value),
    })
}

/// Warns of an amplitude at which the metal breaks in the first cycle.
fn bears(
    tensile: &Spanned<f64>,
    stress: Option<&Spanned<f64>>,
    what: &str,
    reader: &mut Reader,
) -> Option<()> {
    match stress {
        Some(stress) if stress.value >= tensile.value => {
            let shown = |stress_Pa: f64| reader.shown(Dimension::Stress, stress_Pa);
            Diagnostic::error(format!("{what} is not below the tensile strength"))
                .at(stress.place, shown(stress.value))
                .at(tensile.place, shown(tensile.value))
                .refuse(reader)
        }
        _ => Some(()),
    }
}

/// Warns of a tensile strength below the yield strength.
fn yields(tensile: &Spanned<f64>, string: &StringSpec, reader: &mut Reader) -> Option<()> {
    let stronger = string.components.iter().find_map(|component| {
        let yield_Pa = component.yield_strength_Pa?;
        (yield_Pa > tensile.value * (1.0 + 1e-9)).then_some((component, yield_Pa))
    });
    match stronger {
        Some((component, yield_Pa)) => Diagnostic::error(format!(
            "the tensile strength is below the yield strength of `{}`",
            component.name
        ))
        .at(
            tensile.place,
            format!("{} yields at {}", component.name, reader.shown(Dimension::Stress, yield_Pa)),
        )
        .help("it is that of all pipe; without it each grade has its own")
        .refuse(reader),
        None => Some(()),
    }
}
