//! Units of an export, which the file does not give.

use std::ops::RangeInclusive;

use wholestring_units::{Dimension, Unit, number_text};

use super::row::{Row, Rows};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Value,
    fragment::{Block, Origin},
};

/// Dimension of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    Length,
    Diameter,
    LinearWeight,
    Density,
    Force,
    Torque,
    ChartTorque,
    Stress,
    Viscosity,
    ShearStress,
}

/// A measure: its name in `--unit`, its units in both sets, and its plausible range in SI.
struct Declared {
    name: &'static str,
    dimension: Dimension,
    api: &'static str,
    si: &'static str,
    range: RangeInclusive<f64>,
}

const fn declared(
    name: &'static str,
    dimension: Dimension,
    [api, si]: [&'static str; 2],
    range: RangeInclusive<f64>,
) -> Declared {
    Declared { name, dimension, api, si, range }
}

/// In the order of [`Measure`]. The ranges reveal a wrong set of units: feet for metres are a
/// factor of three, inches for millimetres one of 25.
const MEASURES: [Declared; 10] = [
    declared("length", Dimension::Length, ["ft", "m"], -1e3..=2e4),
    declared("diameter", Dimension::Diameter, ["in", "mm"], 0.0..=2.0),
    declared("linear_weight", Dimension::MassPerLength, ["lb/ft", "kg/m"], 0.0..=3e3),
    declared("density", Dimension::Density, ["ppg", "kg/m3"], 0.0..=3e3),
    declared("force", Dimension::Force, ["klbf", "kN"], -2e7..=2e7),
    declared("torque", Dimension::Torque, ["ft-lbf", "kN.m"], 0.0..=1e6),
    declared("chart_torque", Dimension::Torque, ["kft-lbf", "kN.m"], -1e6..=1e6),
    declared("stress", Dimension::Stress, ["psi", "kPa"], 5e7..=3e9),
    declared("viscosity", Dimension::Viscosity, ["cP", "mPa.s"], 0.0..=1e1),
    declared("shear_stress", Dimension::ShearStress, ["lbf/100ft2", "Pa"], 0.0..=1e3),
];

/// A number with its unit from a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub(super) number: f64,
    pub(super) unit: &'static Unit,
}

impl Found {
    pub(super) fn si(self) -> f64 {
        self.unit.to_si(self.number)
    }

    pub(super) fn value(self) -> Value {
        Value::quantity(self.number, self.unit)
    }

    /// Text for messages: `9.625 in`.
    pub(super) fn text(self) -> String {
        format!("{} {}", number_text(self.number), self.unit.symbol)
    }
}

/// The unit of each measure.
#[derive(Debug, Clone)]
pub(super) struct Units(Vec<&'static Unit>);

impl Units {
    /// Reads the user's choice in `--unit edm=SET`, and of single measures.
    pub(super) fn said(rows: &Rows, choices: &Choices) -> Result<Self, ImportError> {
        let mut units = Vec::new();
        let set = choices.said("edm").map(|(_, set)| set);
        if let Some(set) = set.filter(|set| !["api", "si"].contains(set)) {
            let text = format!("--unit edm={set}: expected edm=api or edm=si; {}", sets());
            return Err(rows.error(ImportErrorKind::Refused(text)));
        }
        for measure in MEASURES {
            let single = choices.unit_of(&[measure.name], measure.dimension);
            let symbol = match (single.map_err(|kind| rows.error(kind))?, set) {
                (Some(unit), _) => unit.symbol,
                (None, Some("si")) => measure.si,
                (None, Some(_)) => measure.api,
                (None, None) => return Err(rows.error(unsaid(rows))),
            };
            match measure.dimension.find_unit(symbol) {
                Some(unit) => units.push(unit),
                None => return Err(rows.error(unsaid(rows))),
            }
        }
        Ok(Self(units))
    }

    pub(super) fn of(&self, measure: Measure) -> &'static Unit {
        self.0[measure as usize]
    }

    /// Returns the quantity in a column, checked against its plausible range.
    pub(super) fn quantity(
        &self,
        row: Row,
        column: &str,
        measure: Measure,
    ) -> Result<Option<Found>, ImportError> {
        let Some(number) = row.number(column)? else { return Ok(None) };
        let found = Found { number, unit: self.of(measure) };
        let declared = &MEASURES[measure as usize];
        // A zero means that no value was entered.
        if number != 0.0 && !declared.range.contains(&found.si()) {
            let [from, to] = [declared.range.start(), declared.range.end()]
                .map(|si| number_text(found.unit.from_si(*si)));
            let kind = ImportErrorKind::OutOfRange {
                what: column.to_owned(),
                found: found.text(),
                expected: format!(
                    "{from} to {to} {}, or another unit: --unit {}=UNIT",
                    found.unit.symbol, declared.name
                ),
            };
            return Err(row.error(column, kind));
        }
        Ok(Some(found))
    }

    /// Returns the quantity in a column if it is above zero; a zero means that no value was entered.
    pub(super) fn positive(
        &self,
        row: Row,
        column: &str,
        measure: Measure,
    ) -> Result<Option<Found>, ImportError> {
        match self.quantity(row, column, measure)? {
            Some(found) if found.number < 0.0 => {
                let kind = ImportErrorKind::OutOfRange {
                    what: column.to_owned(),
                    found: found.text(),
                    expected: "more than 0".to_owned(),
                };
                Err(row.error(column, kind))
            }
            found => Ok(found.filter(|found| found.number > 0.0)),
        }
    }

    /// Writes a key if its column is above zero.
    pub(super) fn push(
        &self,
        block: &mut Block,
        key: &'static str,
        row: Row,
        column: &str,
        measure: Measure,
    ) -> Result<Option<Found>, ImportError> {
        let found = self.positive(row, column, measure)?;
        if let Some(found) = found {
            block.push(key, found.value(), Origin::at(row.place(column)));
        }
        Ok(found)
    }
}

/// Both sets of units, for messages.
fn sets() -> String {
    let list = |declared: fn(&Declared) -> &'static str| {
        let mut units: Vec<&str> = MEASURES.iter().map(declared).collect();
        units.dedup();
        units.join(", ")
    };
    format!("api is {}; si is {}", list(|own| own.api), list(|own| own.si))
}

/// Error for a missing set of units, with the set that the file resembles.
fn unsaid(rows: &Rows) -> ImportErrorKind {
    use super::table::Table::{Component, SurveyStation};
    let largest = |table, column: &'static str| {
        let numbers = rows.of(table).filter_map(move |row| row.number(column).ok().flatten());
        let most = numbers.fold(f64::NEG_INFINITY, f64::max);
        let name = super::table::Table::declared(table).name;
        most.is_finite().then(|| format!("the largest {column} of {name} is {}", number_text(most)))
    };
    let seen: Vec<String> = [largest(SurveyStation, "md"), largest(Component, "od_body")]
        .into_iter()
        .flatten()
        .collect();
    let seen = match seen.is_empty() {
        true => String::new(),
        false => format!(" ({})", seen.join("; ")),
    };
    let names: Vec<&str> = MEASURES.iter().map(|own| own.name).collect();
    ImportErrorKind::Refused(format!(
        "an EDM export does not contain its units{seen}; give the set with --unit edm=api, the \
         usual one of Landmark, or --unit edm=si ({}); single units can be given in addition, as \
         --unit length=m, of {}",
        sets(),
        names.join(", ")
    ))
}
