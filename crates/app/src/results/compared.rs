//! Results side by side.

use serde::Serialize;
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_units::UnitSet;

use super::{
    checks::summary,
    curves::{Curve, curves},
    entry::ResultsEntry,
    inputs::{Differing, differing},
    scalars::{Scalar, scalars},
};
use crate::workspace::ResultsPlace;

/// Results side by side.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Compared {
    /// What is compared, in the order in which it was asked for.
    results: Vec<ResultsEntry>,
    /// The inputs that are not the same in all of them.
    inputs: Vec<Differing>,
    /// Numbers that at least one of them has.
    scalars: Vec<ComparedScalar>,
    /// Curves against depth of those that have some.
    curves: Vec<Curve>,
}

/// A number of the results.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ComparedScalar {
    /// What it is of: `trip out (soft)`.
    of: String,
    /// What it is: `Hook load`.
    label: String,
    /// The symbol of its unit.
    unit: String,
    /// Its value in each of the results; null where it has none.
    values: Vec<Option<f64>>,
}

/// Puts results side by side, in these units.
pub(crate) fn compare(places: &[ResultsPlace], units: UnitSet) -> Compared {
    let summaries: Vec<Option<Value>> = places.iter().map(|of| summary(&of.path)).collect();
    let settings: Vec<Option<&Value>> =
        summaries.iter().map(|of| of.as_ref().map(|summary| &summary["settings"])).collect();
    let mut rows: Vec<ComparedScalar> = Vec::new();
    for (place, (results, summary)) in places.iter().zip(&summaries).enumerate() {
        let Some(summary) = summary else { continue };
        for Scalar { of, label, unit, value } in scalars(&results.path, summary, units) {
            let row = rows.iter().position(|row| row.of == of && row.label == label);
            let row = row.unwrap_or_else(|| {
                let values = vec![None; places.len()];
                rows.push(ComparedScalar { of, label, unit, values });
                rows.len() - 1
            });
            rows[row].values[place] = Some(value);
        }
    }
    Compared {
        inputs: differing(&settings),
        scalars: rows,
        curves: places.iter().enumerate().flat_map(|(k, of)| curves(&of.path, k, units)).collect(),
        results: places.iter().map(ResultsEntry::of).collect(),
    }
}
