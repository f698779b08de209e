//! All units, and the unit of each dimension in each set.

use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_runner::display_units;
use wholestring_units::{Dimension, UnitSet};

use crate::words;

/// A dimension's units.
#[derive(Debug, Serialize, ToSchema)]
pub struct DimensionUnits {
    /// SI value of one unit, for every notation of a unit. Empty for dimensions that no case file
    /// has.
    factors: BTreeMap<&'static str, f64>,
    /// The unit in each set, by the set's name.
    #[schema(value_type = BTreeMap<words::UnitSet, ShownUnit>)]
    shown: BTreeMap<&'static str, ShownUnit>,
}

/// A display unit.
#[derive(Debug, Serialize, ToSchema)]
pub struct ShownUnit {
    /// Its notation after a number in a case file. None for dimensions that no case file has.
    symbol: Option<&'static str>,
    /// Its printed symbol.
    label: String,
    /// Its SI value.
    factor: f64,
}

/// All dimensions by name.
pub fn units() -> BTreeMap<String, DimensionUnits> {
    let named = display_units().into_iter().map(|(name, display)| {
        let dimension = Dimension::ALL.iter().find(|dimension| dimension.name() == name);
        let units = dimension.map_or(&[][..], |dimension| dimension.units());
        let spelt = units
            .iter()
            .flat_map(|unit| unit.spellings().map(move |spelling| (spelling, unit.factor)));
        let sets = UnitSet::ALL.iter().zip(display).map(|(set, display)| {
            let symbol = dimension.map(|dimension| dimension.unit_in(*set).symbol);
            (set.name(), ShownUnit { symbol, label: display.symbol, factor: display.factor })
        });
        (name, DimensionUnits { factors: spelt.collect(), shown: sets.collect() })
    });
    named.collect()
}
