//! Columns that figures and tables of a study may show.

use wholestring::{
    dynamics::DynamicOutcome,
    outcome::{self, QuantityKind, TIME_SERIES, WELL_PATH},
};
use wholestring_results::{CONTACT, FRAMES, NODES, TIME, WEAR};
use wholestring_study::{ColumnName, Source};

use crate::{checks::quantities::dimension, sweep::SCALARS};

/// Numbers of findings at each level.
const FINDINGS: [&str; 3] = ["errors", "warnings", "notes"];

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

#[cfg(test)]
mod tests {
    use wholestring_units::Dimension;

    use super::*;

    #[test]
    fn every_column_has_its_dimension() {
        let all = all();
        for (source, name, expected) in [
            (Source::Summary, "hook_load_N", Some(Dimension::Force)),
            (Source::Summary, "twist_rad", Some(Dimension::Angle)),
            (Source::Nodes, "side_force_N_per_m", Some(Dimension::ForcePerLength)),
            (Source::Nodes, "friction_torque_N_m_per_m", None),
            (Source::Wear, "wear_work_J_per_m", None),
            (Source::Time, "time_s", Some(Dimension::Time)),
            (Source::Frames, "contact_force_N", Some(Dimension::Force)),
            (Source::Path, "dogleg_severity_rad_per_m", Some(Dimension::DoglegSeverity)),
            (Source::Path, "md_m", Some(Dimension::Length)),
        ] {
            let found = all.iter().find(|column| column.source == source && column.name == name);
            assert_eq!(found.expect(name).dimension, expected, "{name}");
        }
    }
}
