//! Columns that figures and tables of a study may show, and their labels.

use wholestring::{
    dynamics::DynamicOutcome,
    outcome::{self, QuantityKind, TIME_SERIES, WELL_PATH},
};
use wholestring_report::pretty_symbol;
use wholestring_results::{CONTACT, FRAMES, NODES, TIME, WEAR};
use wholestring_study::{ColumnName, Quantity, Source};
use wholestring_units::{Dimension, UnitSet};

use crate::{checks::quantities::dimension, sweep::SCALARS};

/// Numbers of findings at each level.
pub(super) const FINDINGS: [&str; 3] = ["errors", "warnings", "notes"];

/// Every quantity declared by results, and its source.
fn declared() -> impl Iterator<Item = (Source, outcome::Quantity)> {
    let varying = DynamicOutcome::quantities().filter(|name| !SCALARS.contains(name));
    let scalar = |name: &str| {
        let scalars = outcome::SCALARS.iter().map(|scalar| scalar.quantity);
        let mut all = scalars.chain(TIME_SERIES.iter().map(|series| series.quantity));
        all.find(|quantity| quantity.name == name)
    };
    let counted = |name| {
        let meaning = "Number of findings of the level";
        outcome::Quantity::number(name, QuantityKind::Ratio, meaning)
    };
    let summary = SCALARS.into_iter().chain(varying).filter_map(scalar);
    let summary = summary.chain(FINDINGS.map(counted));
    let tables = [
        (Source::Nodes, NODES),
        (Source::Wear, WEAR),
        (Source::Time, TIME),
        (Source::Frames, FRAMES),
        (Source::Contact, CONTACT),
    ];
    let numbers = tables.into_iter().flat_map(|(source, specs)| {
        let numbers = specs.iter().filter(|spec| !spec.text);
        numbers.map(move |spec| (source, *spec))
    });
    let path = WELL_PATH.iter().map(|column| column.quantity);
    summary
        .map(|summary| (Source::Summary, summary))
        .chain(numbers)
        .chain(path.map(|path| (Source::Path, path)))
}

/// Every column that a study may show.
pub(super) fn all() -> Vec<ColumnName> {
    declared()
        .map(|(source, declared)| ColumnName {
            source,
            name: declared.name,
            dimension: dimension(declared.kind),
        })
        .collect()
}

/// Declaration of a column by its name, which has one meaning in all sources.
fn named(name: &str) -> Option<outcome::Quantity> {
    let found = declared().find(|(_, declared)| declared.name == name);
    found.map(|(_, quantity)| quantity)
}

/// Label of a column: `hook load`.
fn words(name: &str) -> String {
    if name == "cutoff_depth_m" {
        return "cut-off depth".to_owned();
    }
    named(name).map_or_else(|| name.replace('_', " "), |quantity| quantity.words())
}

/// Label of a quantity, without its unit.
pub(super) fn title(quantity: &Quantity) -> String {
    let words = words(quantity.column.name);
    match quantity.magnitude {
        true => format!("magnitude of {words}"),
        false => words,
    }
}

/// Display unit of a quantity, and its value in SI.
pub(super) fn unit(dimension: Option<Dimension>, name: &str, units: UnitSet) -> (String, f64) {
    if let Some(dimension) = dimension {
        let unit = dimension.unit_in(units);
        return (pretty_symbol(unit.symbol), unit.factor);
    }
    let plain = named(name).map_or("", |quantity| quantity.unit);
    (plain.to_owned(), 1.0)
}

/// Label of a name and its unit, with a capital: `Hook load, kN`.
pub(super) fn label(name: &str, unit: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let name: String = first.chain(letters).collect();
    match unit {
        "" => name,
        unit => format!("{name}, {unit}"),
    }
}

/// Whether the column is a depth, which is drawn downwards and, as for time, without margins.
pub(super) fn is_depth(name: &str) -> bool {
    matches!(name, "md_m" | "tvd_m" | "bit_depth_m" | "cutoff_depth_m")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_its_dimension_and_its_name() {
        let all = all();
        let column = |source, name| {
            let found = all.iter().find(|column| column.source == source && column.name == name);
            found.unwrap_or_else(|| panic!("{name}"))
        };
        for (source, name, expected, called) in [
            (Source::Summary, "hook_load_N", Some(Dimension::Force), "hook load"),
            (Source::Summary, "twist_rad", Some(Dimension::Angle), "twist"),
            (Source::Nodes, "side_force_N_per_m", Some(Dimension::ForcePerLength), "side force"),
            (Source::Nodes, "friction_torque_N_m_per_m", None, "friction torque"),
            (Source::Wear, "wear_work_J_per_m", None, "wear work"),
            (Source::Time, "time_s", Some(Dimension::Time), "time"),
            (Source::Frames, "contact_force_N", Some(Dimension::Force), "contact force"),
            (
                Source::Path,
                "dogleg_severity_rad_per_m",
                Some(Dimension::DoglegSeverity),
                "dogleg severity",
            ),
            (Source::Path, "md_m", Some(Dimension::Length), "measured depth"),
        ] {
            assert_eq!(column(source, name).dimension, expected, "{name}");
            assert_eq!(words(name), called);
        }
        assert_eq!(label("hook load", "kN"), "Hook load, kN");
        assert_eq!(unit(None, "wear_work_J_per_m", UnitSet::Field), ("J/m".into(), 1.0));
    }
}
