//! Numbers of a static BHA analysis as text.

use wholestring_units::{Dimension, UnitSet, without_trailing_zeros};

/// Four digits of a quantity, with its unit.
pub fn bha_quantity(si: f64, dimension: Dimension, units: UnitSet) -> String {
    let number = bha_number(si, dimension, units);
    format!("{} {}", without_trailing_zeros(&number), dimension.unit_in(units).symbol)
}

/// A number in the chosen unit, with four digits or to the third decimal; a length to the second
/// decimal at least, because contacts are identified by their depth.
pub fn bha_number(si: f64, dimension: Dimension, units: UnitSet) -> String {
    let value = dimension.unit_in(units).from_si(si);
    let digits = match value.abs() {
        size if size >= 10.0 && dimension == Dimension::Length => 2,
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => 3,
    };
    let text = format!("{value:.digits$}");
    if text.trim_matches(['-', '0', '.']).is_empty() { "0".to_owned() } else { text }
}
