//! Units: which there are, and in which each set shows a dimension.

use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_runner::display_units;
use wholestring_units::{Dimension, UnitSet};

/// A dimension's units.
#[derive(Debug, Serialize, ToSchema)]
pub struct DimensionUnits {
    /// By every way to write a unit, how much of SI it is. None where nobody writes the dimension.
    factors: BTreeMap<&'static str, f64>,
    /// The unit in which each set shows it, by the set's name.
    shown: BTreeMap<&'static str, ShownUnit>,
}

/// A unit in which numbers are shown.
#[derive(Debug, Serialize, ToSchema)]
pub struct ShownUnit {
    /// As it is written behind a number in a case file. None where nobody writes the dimension.
    symbol: Option<&'static str>,
    /// As it is printed.
    label: String,
    /// How much of SI it is.
    factor: f64,
}

/// Every dimension by its name.
pub fn units() -> BTreeMap<String, DimensionUnits> {
    let named = display_units().into_iter().map(|(name, shown)| {
        let dimension = Dimension::ALL.iter().find(|of| of.name() == name);
        let units = dimension.map_or(&[][..], |of| of.units());
        let spelt = units.iter().flat_map(|unit| unit.spellings().map(move |of| (of, unit.factor)));
        let sets = UnitSet::ALL.iter().zip(shown).map(|(set, shown)| {
            let symbol = dimension.map(|of| of.unit_in(*set).symbol);
            (set.name(), ShownUnit { symbol, label: shown.symbol, factor: shown.factor })
        });
        (name, DimensionUnits { factors: spelt.collect(), shown: sets.collect() })
    });
    named.collect()
}
