//! Numbers in the reader's units.

use std::collections::BTreeMap;

use wholestring_units::{UnitSet, without_trailing_zeros};

use crate::{Cell, DisplayUnit, Fact, dimensions::UNIT_SETS};

/// The units in which the reader sees numbers.
#[derive(Clone, Copy)]
pub(crate) struct DisplayUnits<'a> {
    dimensions: &'a BTreeMap<String, [DisplayUnit; 3]>,
    /// Place of the reader's set among the sets of units.
    set: usize,
}

/// Sets of units by their place in [`crate::PageHead::dimensions`].
pub(crate) const SETS: [&str; 3] = ["si", "metric", "field"];

impl<'a> DisplayUnits<'a> {
    pub(crate) fn new(dimensions: &'a BTreeMap<String, [DisplayUnit; 3]>, units: &str) -> Self {
        let set = SETS.iter().position(|name| *name == units);
        Self { dimensions, set: set.unwrap_or(0) }
    }

    /// The reader's set of units.
    pub(crate) fn unit_set(&self) -> UnitSet {
        UNIT_SETS[self.set]
    }

    fn unit(&self, dimension: &str) -> Option<&'a DisplayUnit> {
        Some(&self.dimensions.get(dimension)?[self.set])
    }

    pub(crate) fn symbol(&self, dimension: &str) -> &'a str {
        self.unit(dimension).map_or("", |unit| &unit.symbol)
    }

    pub(crate) fn value(&self, si: f64, dimension: &str) -> f64 {
        si / self.unit(dimension).map_or(1.0, |unit| unit.factor)
    }

    /// Values of a column.
    pub(crate) fn values(&self, si: &[f64], dimension: &str) -> Vec<f64> {
        si.iter().map(|value| self.value(*value, dimension)).collect()
    }

    /// Label of an axis, unit included.
    pub(crate) fn label(&self, name: &str, dimension: &str) -> String {
        match self.symbol(dimension) {
            "" => name.to_owned(),
            symbol => format!("{name}, {symbol}"),
        }
    }

    /// A quantity with its unit, in its usual number of digits.
    pub(crate) fn quantity(&self, si: f64, dimension: &str) -> String {
        let number = plain(self.value(si, dimension));
        match self.symbol(dimension) {
            "" => number,
            "°" => number + "°",
            symbol => format!("{number} {symbol}"),
        }
    }

    /// A depth in whole metres or feet.
    pub(crate) fn depth(&self, si: f64) -> String {
        // The surface is at 0, not at -0.
        let whole = self.value(si, "length").round() + 0.0;
        format!("{whole:.0} {}", self.symbol("length")).trim_end().to_owned()
    }

    /// `bit depth 4305 m`; `None` for an empty fact.
    pub(crate) fn fact(&self, fact: &Fact) -> Option<String> {
        let value = match &fact.value {
            Cell::Quantity { value, dimension, .. } => self.quantity(*value, dimension),
            Cell::Quantities { values, dimension } => {
                let values = values.iter().map(|value| self.quantity(*value, dimension));
                values.collect::<Vec<_>>().join(", ")
            }
            Cell::Number(value) => plain(*value),
            Cell::Text(text) | Cell::Link { text, .. } => text.clone(),
            Cell::Nothing => return None,
        };
        Some(format!("{} {value}", fact.label.to_lowercase()))
    }
}

/// A number in five digits at most, without trailing zeros.
fn plain(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let whole = value.abs().log10().floor() as i32 + 1;
    let digits = (5 - whole).clamp(0, 8) as usize;
    let text = format!("{value:.digits$}");
    without_trailing_zeros(&text).replace('-', "\u{2212}")
}
