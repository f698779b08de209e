//! Units of each dimension on the page.

use std::{collections::BTreeMap, f64::consts::TAU};

use serde::{Deserialize, Serialize};
use wholestring_units::{Dimension, UnitSet};

/// Sets of units of a page, in its order.
pub(crate) const UNIT_SETS: [UnitSet; 3] = [UnitSet::Si, UnitSet::Metric, UnitSet::Field];

/// Dimensions that appear only in output: name, then symbol and factor in each set.
const OTHERS: &[(&str, [(&str, f64); 3])] = &[
    ("ratio", [("", 1.0); 3]),
    ("percent", [("%", 0.01); 3]),
    ("turns", [("rev", TAU); 3]),
    ("work per length", [("kJ/m", 1e3), ("kJ/m", 1e3), ("ft·lbf/ft", 4.448_221_615_260_5)]),
    ("work per volume", [("MJ/m³", 1e6), ("MJ/m³", 1e6), ("psi", 6_894.757_293_168_361)]),
    ("lateral speed", [("m/s", 1.0), ("m/s", 1.0), ("ft/s", 0.3048)]),
    ("modulus", [("GPa", 1e9), ("GPa", 1e9), ("Mpsi", 6.894_757_293_168_361e9)]),
    ("specific energy", [("MPa", 1e6), ("MPa", 1e6), ("psi", 6_894.757_293_168_361)]),
    ("energy", [("kJ", 1e3), ("kJ", 1e3), ("ft·lbf", 1.355_817_948_331_400_4)]),
    ("time step", [("ms", 1e-3); 3]),
];

/// A unit as shown to users.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DisplayUnit {
    /// Its symbol; empty for a bare number.
    pub symbol: String,
    /// SI units in one of it.
    pub factor: f64,
}

/// A value in SI, metric and field units.
pub(crate) fn in_sets<T>(value: impl FnMut(UnitSet) -> T) -> [T; 3] {
    UNIT_SETS.map(value)
}

/// Every dimension by its name, and its unit in each set: SI, metric, field.
pub fn display_units() -> BTreeMap<String, [DisplayUnit; 3]> {
    let known = Dimension::ALL.iter().map(|dimension| {
        let units = UNIT_SETS.map(|set| {
            let unit = dimension.unit_in(set);
            DisplayUnit { symbol: pretty_symbol(unit.symbol), factor: unit.factor }
        });
        (dimension.name().to_owned(), units)
    });
    let others = OTHERS.iter().map(|(name, units)| {
        let units = units.map(|(symbol, factor)| DisplayUnit { symbol: symbol.into(), factor });
        ((*name).to_owned(), units)
    });
    known.chain(others).collect()
}

/// Unit of a dimension by its name in a set of units; `None` for a bare number.
pub fn display_unit(dimension: &str, units: UnitSet) -> Option<DisplayUnit> {
    let place = UNIT_SETS.iter().position(|set| *set == units)?;
    display_units().remove(dimension).map(|sets| sets[place].clone())
}

/// The symbol for display: `kN.m` becomes `kN·m`, `deg/30m` becomes `°/30 m`.
pub fn pretty_symbol(symbol: &str) -> String {
    [
        ("deg", "°"),
        ("ft-lbf", "ft·lbf"),
        ("in-lbf/in2", "in·lbf/in²"),
        (".", "·"),
        ("m3", "m³"),
        ("m2", "m²"),
        ("/100ft2", "/100 ft²"),
        ("ft2", "ft²"),
        ("^n", "ⁿ"),
        ("/30m", "/30 m"),
        ("/100ft", "/100 ft"),
    ]
    .iter()
    .fold(symbol.to_owned(), |text, (from, to)| text.replace(from, to))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use wholestring::outcome::QuantityKind;

    use super::*;

    #[test]
    fn symbols_are_printed_as_the_field_prints_them() {
        let all = display_units();
        for (name, expected) in [
            ("torque", ["kN·m", "kN·m", "ft·lbf"]),
            ("dogleg severity", ["°/30 m", "°/30 m", "°/100 ft"]),
            ("density", ["kg/m³", "sg", "ppg"]),
            ("force", ["kN", "t", "klbf"]),
            ("fracture energy", ["kJ/m²", "kJ/m²", "in·lbf/in²"]),
            ("shear stress", ["Pa", "Pa", "lbf/100 ft²"]),
        ] {
            let symbols = all[name].each_ref().map(|unit| unit.symbol.as_str());
            assert_eq!(symbols, expected);
        }
        let per_metre = (3.0 * PI / 180.0) / 30.0;
        assert!((per_metre / all["dogleg severity"][0].factor - 3.0).abs() < 1e-12);
        assert!((per_metre / all["dogleg severity"][2].factor - 3.048).abs() < 1e-12);
    }

    /// Pages show the SI unit of columns without a conversion.
    #[test]
    fn a_kind_of_quantity_has_units() {
        let all = display_units();
        for kind in QuantityKind::ALL {
            let plain = ["torque per length", "power per length"].contains(&kind.dimension());
            assert_ne!(all.contains_key(kind.dimension()), plain, "{kind:?}");
        }
    }
}
