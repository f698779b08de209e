//! Whether the cases of a study solve what its figures and tables show.

use std::collections::BTreeSet;

use wholestring_study::{Chosen, Study};

use crate::sweep::CheckedPoints;

/// A sentence for each figure and each row of a table whose methods or operations no case of its
/// sweeps solves.
pub(super) fn without_results(study: &Study, valid: &CheckedPoints) -> Vec<String> {
    let figures = study.figures.iter().filter_map(|figure| {
        without(&format!("figure `{}`", figure.name), &figure.chosen, study, valid)
    });
    let rows = study.tables.iter().flat_map(|table| {
        let place = |label: &str| format!("row \"{label}\" of table `{}`", table.name);
        table.rows.iter().map(move |row| (place(&row.label), &row.chosen))
    });
    figures
        .chain(rows.filter_map(|(place, chosen)| without(&place, chosen, study, valid)))
        .collect()
}

/// The sentence of one figure or row.
fn without(place: &str, chosen: &Chosen, study: &Study, valid: &CheckedPoints) -> Option<String> {
    let (mut models, mut operations) = (BTreeSet::new(), BTreeSet::new());
    for (set, solved, kinds) in valid.solves() {
        if !chosen.sweeps.contains(&set) {
            continue;
        }
        let has_model =
            chosen.models.is_empty() || solved.iter().any(|model| chosen.models.contains(model));
        let has_operation = chosen.operations.is_empty()
            || kinds.iter().any(|kind| chosen.operations.contains(kind));
        if has_model && has_operation {
            return None;
        }
        models.extend(solved.iter().map(|model| model.name()));
        operations.extend(kinds.iter().map(|kind| kind.name()));
    }
    let listed = |names: BTreeSet<&str>| names.into_iter().collect::<Vec<_>>().join(", ");
    let shown = chosen.models.iter().map(|model| model.name());
    let shown = shown.chain(chosen.operations.iter().map(|kind| kind.name()));
    let sweeps = chosen.sweeps.iter().map(|sweep| study.sweeps[*sweep].name.as_str());
    Some(format!(
        "{place} has no results: it shows {}, and the cases of {} solve {} by {}",
        shown.collect::<Vec<_>>().join(", "),
        sweeps.collect::<Vec<_>>().join(", "),
        listed(operations),
        listed(models),
    ))
}
