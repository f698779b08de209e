//! Units of each dimension on the page.

use std::{collections::BTreeMap, f64::consts::TAU};

use wholestring_case::dimension_of;
use wholestring_report::DisplayUnit;
use wholestring_units::{Dimension, UnitSet};

/// Sets of units of a page, in its order.
pub(super) const SETS: [UnitSet; 3] = [UnitSet::Si, UnitSet::Metric, UnitSet::Field];

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

/// Every dimension by its name, and its unit in each set: SI, metric, field.
pub fn all() -> BTreeMap<String, [DisplayUnit; 3]> {
    let known = Dimension::ALL.iter().map(|dimension| {
        let units = SETS.map(|set| {
            let unit = dimension.unit_in(set);
            DisplayUnit { symbol: pretty(unit.symbol), factor: unit.factor }
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
pub(crate) fn unit(dimension: &str, units: UnitSet) -> Option<DisplayUnit> {
    let place = SETS.iter().position(|set| *set == units)?;
    all().remove(dimension).map(|sets| sets[place].clone())
}

/// The symbol for display: `kN.m` becomes `kN·m`, `deg/30m` becomes `°/30 m`.
pub(crate) fn pretty(symbol: &str) -> String {
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

/// Dimension of a key of the settings on the page, and its name without the unit; `None` for a bare
/// number.
pub(crate) fn of_setting(key: &str) -> Option<(&'static str, &str)> {
    if let Some(name) = key.strip_suffix("_J_per_m3") {
        return Some(("work per volume", name));
    }
    let (dimension, name) = dimension_of(key)?;
    Some(match dimension {
        // In GPa, unlike pressures.
        Dimension::Pressure if name.ends_with("modulus") => ("modulus", name),
        other => (other.name(), name),
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use wholestring::outcome::QuantityKind;

    use super::*;

    #[test]
    fn symbols_are_printed_as_the_field_prints_them() {
        let all = all();
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
        let all = all();
        for kind in QuantityKind::ALL {
            let plain = ["torque per length", "power per length"].contains(&kind.dimension());
            assert_ne!(all.contains_key(kind.dimension()), plain, "{kind:?}");
        }
    }

    #[test]
    fn keys_of_the_settings_have_their_dimension() {
        for (key, expected) in [
            ("bit_depth_m", "length"),
            ("od_m", "diameter"),
            ("diameter_m", "diameter"),
            ("gauge_relief_m", "diameter"),
            ("mass_per_length_kg_per_m", "mass per length"),
            ("youngs_modulus_Pa", "modulus"),
            ("yield_strength_Pa", "pressure"),
            ("rock_stiffness_N_per_m", "stiffness"),
            ("top_drive_torque_N_m", "torque"),
            ("rotary_speed_rad_per_s", "rotary speed"),
            ("gain_m_per_s_per_N", "hoist gain"),
            ("rop_m_per_s", "rate of penetration"),
            ("settle_s", "time"),
        ] {
            let found = of_setting(key).map(|(dimension, _)| dimension);
            assert_eq!(found, Some(expected), "{key}");
            assert!(all().contains_key(expected), "{expected}");
        }
        assert_eq!(of_setting("seed"), None);
    }
}
