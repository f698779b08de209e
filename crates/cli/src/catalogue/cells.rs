//! Headings and numbers of the catalogue's tables.

use wholestring_units::{Dimension, Unit, UnitSet};

/// A heading with the unit of its column.
pub(super) fn heading(what: &str, unit: &Unit) -> String {
    format!("{what} {}", unit.symbol)
}

/// The units of dimensions in a set.
pub(super) fn units_of<const N: usize>(
    dimensions: [Dimension; N],
    units: UnitSet,
) -> [&'static Unit; N] {
    dimensions.map(|dimension| dimension.unit_in(units))
}

/// Rounded to three digits or to the unit, whichever is finer.
pub(super) fn number(unit: &Unit, si: f64) -> String {
    let value = unit.from_si(si);
    let decimals = if value.abs() < 99.95 { 1 } else { 0 };
    format!("{value:.decimals$}")
}
