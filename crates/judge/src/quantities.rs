//! Scalars of an answer in the units that people see.

use std::f64::consts::TAU;

use wholestring::outcome::QuantityKind;
use wholestring_units::{Dimension, UnitSet};

/// The dimension in whose units people see a kind of quantity; none where no unit converts it.
pub fn dimension(kind: QuantityKind) -> Option<Dimension> {
    Dimension::ALL.iter().copied().find(|dimension| dimension.name() == kind.dimension())
}

/// Symbol of the unit in which people see a kind of quantity: turns of the string say more than
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

/// A deviation with two significant digits; `0` where it is less than anybody measures.
pub fn deviation(shown: f64) -> String {
    if !shown.is_finite() {
        return "–".to_owned();
    }
    if shown < 1e-4 {
        return "0".to_owned();
    }
    let decimals = (1.0 - libm::log10(shown).floor()).clamp(0.0, 4.0) as usize;
    format!("{shown:.decimals$}")
}
