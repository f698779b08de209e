//! Dimensions of the keys of the settings.

use std::{collections::BTreeMap, sync::LazyLock};

use wholestring_config::Json;
use wholestring_units::{Dimension, Unit};

use crate::{case::table::TABLES, edit::overrides::long_key};

/// Keys of the settings that no table declares and whose unit does not determine their dimension:
/// key, name without unit, dimension.
const OF_THE_RECORD: &[(&str, &str, Dimension)] = &[
    ("radius_m", "radius", Dimension::Diameter),
    ("core_radius_m", "core_radius", Dimension::Diameter),
    ("frequency_Hz", "frequency", Dimension::Frequency),
    ("rate_of_penetration_m_per_s", "rate_of_penetration", Dimension::RateOfPenetration),
    ("bending_Pa", "bending", Dimension::Stress),
];

/// Words in the names of stresses, which share their unit with pressures.
const OF_STRESSES: [&str; 4] = ["stress", "strength", "modulus", "specific_energy"];

/// Dimensions by unit, for keys without another rule.
const BY_UNIT: &[Dimension] = &[
    Dimension::Length,
    Dimension::Force,
    Dimension::Torque,
    Dimension::Pressure,
    Dimension::Density,
    Dimension::MassPerLength,
    Dimension::ForcePerLength,
    Dimension::RotarySpeed,
    Dimension::TripSpeed,
    Dimension::Angle,
    Dimension::Damping,
    Dimension::Viscosity,
    Dimension::Consistency,
    Dimension::FlowRate,
    Dimension::Volume,
    Dimension::DissipationTime,
    Dimension::HoistGain,
    Dimension::Time,
    Dimension::Frequency,
    Dimension::Mass,
    Dimension::MomentOfInertia,
    Dimension::RotaryDamping,
    Dimension::FractureEnergy,
];

/// Returns the dimension of a key of [`Case::settings`](crate::Case::settings), and its name
/// without the unit; `None` for a bare number or a value that is not a number.
///
/// A key of the case file has the dimension that its table declares, any other that of its unit.
///
/// ```
/// use wholestring_case::dimension_of;
/// use wholestring_units::{Dimension, Unit};
///
/// assert_eq!(dimension_of("bit_depth_m"), Some((Dimension::Length, "bit_depth")));
/// assert_eq!(dimension_of("wear_flat_m"), Some((Dimension::Diameter, "wear_flat")));
/// assert_eq!(dimension_of("seed"), None);
/// ```
pub fn dimension_of(key: &str) -> Option<(Dimension, &str)> {
    if let Some(dimension) = DECLARED.get(key) {
        return Some((*dimension, without(key, *dimension)?));
    }
    let of_the_record = OF_THE_RECORD.iter().find(|(own, ..)| *own == key);
    if let Some((_, name, dimension)) = of_the_record {
        return Some((*dimension, name));
    }
    BY_UNIT
        .iter()
        .filter_map(|dimension| Some((*dimension, without(key, *dimension)?)))
        // The longer unit wins: `m_per_s` over `per_s`.
        .min_by_key(|(_, name)| name.len())
        .map(|(dimension, name)| match dimension {
            Dimension::Pressure if OF_STRESSES.iter().any(|word| name.contains(word)) => {
                (Dimension::Stress, name)
            }
            other => (other, name),
        })
}

/// Returns the dimension of the value of a dotted or short key of the case file, lists counted from
/// zero; `None` for a bare number, for a value that is not a number, and for an unknown key.
///
/// ```
/// use wholestring_case::dimension_at;
/// use wholestring_units::{Dimension, Unit};
///
/// assert_eq!(dimension_at("well.hole.0.diameter"), Some(Dimension::Diameter));
/// assert_eq!(dimension_at("wob"), Some(Dimension::Force));
/// assert_eq!(dimension_at("well.stations.3.1"), Some(Dimension::Angle));
/// assert_eq!(dimension_at("well.hole.0.friction"), None);
/// ```
pub fn dimension_at(path: &str) -> Option<Dimension> {
    at(&TABLES, &mut long_key(path).split('.')).and_then(declared_by)
}

/// Returns the unit of a bare number of a dotted or short key of a case file: SI, and rev/min for
/// rotary speeds. `None` for a pure number, a text, a number of a station, which is in metres or
/// degrees as its columns are, or an unknown key.
///
/// ```
/// use wholestring_case::unit_of_key;
///
/// assert_eq!(unit_of_key("wob").map(|unit| unit.symbol), Some("N"));
/// assert_eq!(unit_of_key("operation.rpm").map(|unit| unit.symbol), Some("rpm"));
/// assert_eq!(unit_of_key("seed"), None);
/// ```
pub fn unit_of_key(path: &str) -> Option<&'static Unit> {
    let is_station = path.starts_with("well.stations.");
    let dimension = dimension_at(path).filter(|_| !is_station)?;
    let symbol = match dimension {
        Dimension::RotarySpeed => "rpm",
        other => other.si_symbol(),
    };
    dimension.find_unit(symbol)
}

/// Returns the schema of the place to which keys lead.
fn at<'a>(schema: &'a Json, keys: &mut dyn Iterator<Item = &str>) -> Option<&'a Json> {
    let Some(key) = keys.next() else { return Some(schema) };
    let rest: Vec<&str> = keys.collect();
    let either = schema["anyOf"].as_array().into_iter().flatten();
    std::iter::once(schema).chain(either).find_map(|schema| {
        let below = match &schema["properties"][key] {
            Json::Null => in_list(schema, key)?,
            below => below,
        };
        at(below, &mut rest.iter().copied())
    })
}

/// Returns the schema of an item of a list.
fn in_list<'a>(schema: &'a Json, key: &str) -> Option<&'a Json> {
    let is_index = key == "*" || key.bytes().all(|byte| byte.is_ascii_digit());
    let of_place = || schema["prefixItems"].get(key.parse::<usize>().ok()?);
    of_place().or_else(|| schema.get("items").filter(|_| is_index))
}

/// Returns the name before a dimension's unit.
fn without(key: &str, dimension: Dimension) -> Option<&str> {
    key.strip_suffix(&dimension.suffix())?.strip_suffix('_')
}

/// The keys of all tables, with the units that they have in the settings.
static DECLARED: LazyLock<BTreeMap<String, Dimension>> = LazyLock::new(|| {
    let mut declared = BTreeMap::new();
    visit(&TABLES, &mut |key, dimension| {
        declared.insert(format!("{key}_{}", dimension.suffix()), dimension);
    });
    declared
});

/// Visits every key of a schema that has a dimension.
fn visit(schema: &Json, each: &mut impl FnMut(&str, Dimension)) {
    match schema {
        Json::Object(object) => {
            if let Some(Json::Object(keys)) = object.get("properties") {
                for (key, value) in keys {
                    if let Some(dimension) = declared_by(value) {
                        each(key, dimension);
                    }
                }
            }
            object.values().for_each(|value| visit(value, each));
        }
        Json::Array(items) => items.iter().for_each(|value| visit(value, each)),
        _ => {}
    }
}

/// Returns the dimension of a value, of an item of a list, or of one of several alternatives.
fn declared_by(value: &Json) -> Option<Dimension> {
    if let Some(name) = value["x-dimension"].as_str() {
        return Dimension::ALL.iter().find(|dimension| dimension.name() == name).copied();
    }
    let either = value["anyOf"].as_array().into_iter().flatten();
    either.chain(value.get("items")).find_map(declared_by)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// If two tables gave one key in one unit different meanings, their names would have to be
    /// distinguished.
    #[test]
    fn a_key_measures_the_same_in_every_table() {
        let mut declared: BTreeMap<String, Dimension> = BTreeMap::new();
        let mut keys = 0;
        visit(&TABLES, &mut |key, dimension| {
            keys += 1;
            let key = format!("{key}_{}", dimension.suffix());
            if let Some(other) = declared.insert(key.clone(), dimension) {
                assert_eq!(other, dimension, "{key}");
            }
        });
        assert!(keys > 100, "{keys} keys have a dimension");
    }

    #[test]
    fn undeclared_keys_measure_what_their_unit_says() {
        for (key, expected) in [
            ("from_m", Dimension::Length),
            ("core_radius_m", Dimension::Diameter),
            ("frequency_Hz", Dimension::Frequency),
            ("rotary_speed_rad_per_s", Dimension::RotarySpeed),
            ("mass_per_s", Dimension::Frequency),
            ("consistency_Pa_s_n", Dimension::Consistency),
            ("pump_pressure_Pa", Dimension::Pressure),
            ("largest_von_mises_stress_Pa", Dimension::Stress),
            ("mechanical_specific_energy_Pa", Dimension::Stress),
        ] {
            assert_eq!(dimension_of(key).map(|(dimension, _)| dimension), Some(expected), "{key}");
        }
    }
}
