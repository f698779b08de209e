//! What figures and tables of a study may show, and what people call it.

use wholestring::dynamics::DynamicOutcome;
use wholestring_results::{CONTACT, ColumnSpec, FRAMES, NODES, TIME, WEAR};
use wholestring_study::{ColumnName, Quantity, Source};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    page::{
        dimensions::{of_key, pretty},
        well::WellBore,
    },
    sweep::SCALARS,
};

/// Ends of names that no set of units converts, and their units.
const PLAIN: &[(&str, &str)] = &[
    ("_N_m_per_m", "N·m/m"),
    ("_J_per_m", "J/m"),
    ("_W_per_m", "W/m"),
];

/// Ends of names of curvatures.
const CURVATURE: &str = "_rad_per_m";

/// How many findings of each level there are.
pub(super) const FINDINGS: [&str; 3] = ["errors", "warnings", "notes"];

/// Every column that a study may show.
pub(super) fn all() -> Vec<ColumnName> {
    let of = |source: Source, name: &'static str| ColumnName {
        source,
        name,
        dimension: dimension(name),
    };
    let varying = DynamicOutcome::quantities().filter(|name| !SCALARS.contains(name));
    let summary = SCALARS.into_iter().chain(varying).chain(FINDINGS);
    let numbers = |source, specs: &'static [ColumnSpec]| {
        let numbers = specs.iter().filter(|spec| !spec.text);
        numbers.map(move |spec| of(source, spec.name))
    };
    summary
        .map(|name| of(Source::Summary, name))
        .chain(numbers(Source::Nodes, NODES))
        .chain(numbers(Source::Wear, WEAR))
        .chain(numbers(Source::Time, TIME))
        .chain(numbers(Source::Frames, FRAMES))
        .chain(numbers(Source::Contact, CONTACT))
        .chain(WellBore::COLUMNS.map(|(name, _)| of(Source::Path, name)))
        .collect()
}

fn dimension(name: &str) -> Option<Dimension> {
    if name.ends_with(CURVATURE) {
        return Some(Dimension::DoglegSeverity);
    }
    if PLAIN.iter().any(|(end, _)| name.ends_with(end)) {
        return None;
    }
    let (dimension, _) = of_key(name)?;
    Dimension::ALL
        .iter()
        .copied()
        .find(|of| of.name() == dimension)
}

/// What people call a column: `hook load`.
fn words(name: &str) -> String {
    let plain = PLAIN.iter().find_map(|(end, _)| name.strip_suffix(end));
    let stem = plain.or_else(|| name.strip_suffix(CURVATURE));
    let stem = stem
        .or_else(|| of_key(name).map(|(_, stem)| stem))
        .unwrap_or(name);
    match stem {
        "md" => "measured depth".into(),
        "tvd" => "true vertical depth".into(),
        other => other.replace('_', " "),
    }
}

/// What people call a quantity, without its unit.
pub(super) fn title(quantity: &Quantity) -> String {
    let words = words(quantity.column.name);
    match quantity.magnitude {
        true => format!("magnitude of {words}"),
        false => words,
    }
}

/// The unit in which people see a quantity, and what it is worth in SI.
pub(super) fn unit(dimension: Option<Dimension>, name: &str, units: UnitSet) -> (String, f64) {
    if let Some(dimension) = dimension {
        let unit = dimension.unit_in(units);
        return (pretty(unit.symbol), unit.factor);
    }
    let plain = PLAIN.iter().find(|(end, _)| name.ends_with(end));
    (
        plain.map_or(String::new(), |(_, unit)| (*unit).to_owned()),
        1.0,
    )
}

/// A name and its unit, the first letter large: `Hook load, kN`.
pub(super) fn label(name: &str, unit: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let name: String = first.chain(letters).collect();
    match unit {
        "" => name,
        unit => format!("{name}, {unit}"),
    }
}

/// A depth is drawn downwards, and like time exactly as far as it goes.
pub(super) fn is_depth(name: &str) -> bool {
    matches!(name, "md_m" | "tvd_m" | "bit_depth_m")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_its_dimension_and_its_name() {
        let all = all();
        let column = |source, name| {
            let found = all.iter().find(|of| of.source == source && of.name == name);
            found.unwrap_or_else(|| panic!("{name}"))
        };
        for (source, name, expected, called) in [
            (
                Source::Summary,
                "hook_load_N",
                Some(Dimension::Force),
                "hook load",
            ),
            (
                Source::Summary,
                "twist_rad",
                Some(Dimension::Angle),
                "twist",
            ),
            (
                Source::Nodes,
                "side_force_N_per_m",
                Some(Dimension::ForcePerLength),
                "side force",
            ),
            (
                Source::Nodes,
                "friction_torque_N_m_per_m",
                None,
                "friction torque",
            ),
            (Source::Wear, "wear_work_J_per_m", None, "wear work"),
            (Source::Time, "time_s", Some(Dimension::Time), "time"),
            (
                Source::Frames,
                "contact_force_N",
                Some(Dimension::Force),
                "contact force",
            ),
            (
                Source::Path,
                "dogleg_severity_rad_per_m",
                Some(Dimension::DoglegSeverity),
                "dogleg severity",
            ),
            (
                Source::Path,
                "md_m",
                Some(Dimension::Length),
                "measured depth",
            ),
        ] {
            assert_eq!(column(source, name).dimension, expected, "{name}");
            assert_eq!(words(name), called);
        }
        assert_eq!(label("hook load", "kN"), "Hook load, kN");
        assert_eq!(
            unit(None, "wear_work_J_per_m", UnitSet::Field),
            ("J/m".into(), 1.0)
        );
    }
}
