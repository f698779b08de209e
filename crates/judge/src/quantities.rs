//! Scalars of a result in the units that users see.

use std::f64::consts::TAU;

use wholestring::outcome::QuantityKind;
use wholestring_units::{Dimension, UnitSet};

/// The dimension in whose units users see a kind of quantity; `None` where no unit converts it.
pub fn dimension(kind: QuantityKind) -> Option<Dimension> {
    Dimension::ALL.iter().copied().find(|dimension| dimension.name() == kind.dimension())
}

/// Symbol of the unit in which users see a kind of quantity. Turns of the string are clearer than
/// radians.
pub fn symbol(kind: QuantityKind, units: UnitSet) -> &'static str {
    match (kind, dimension(kind)) {
        (QuantityKind::Angle, _) => "rev",
        (_, Some(dimension)) => dimension.unit_in(units).symbol,
        (_, None) => kind.unit(),
    }
}

/// The value in that unit.
pub fn shown(kind: QuantityKind, si: f64, units: UnitSet) -> f64 {
    match (kind, dimension(kind)) {
        (QuantityKind::Angle, _) => si / TAU,
        (_, Some(dimension)) => dimension.unit_in(units).from_si(si),
        (_, None) => si,
    }
}

/// A deviation with two significant digits; `0` where it is below any measurement.
pub fn deviation(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value < 1e-4 {
        return "0".to_owned();
    }
    let decimals = (1.0 - libm::log10(value).floor()).clamp(0.0, 4.0) as usize;
    format!("{value:.decimals$}")
}
