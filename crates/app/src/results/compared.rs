//! Comparison of results.

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
    /// The compared results, in the order of the request.
    results: Vec<ResultsEntry>,
    /// The inputs that differ between them.
    inputs: Vec<Differing>,
    /// Numbers that at least one of them has.
    scalars: Vec<ComparedScalar>,
    /// Curves against depth of those that have some.
    curves: Vec<Curve>,
}

/// A number of the results.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ComparedScalar {
    /// Its operation and model: `trip out (soft)`.
    of: String,
    /// Its label: `Hook load`.
    label: String,
    /// The symbol of its unit.
    unit: String,
    /// Its value in each of the results; null if it has none.
    values: Vec<Option<f64>>,
}

/// Compares results, in these units.
pub(crate) fn compare(places: &[ResultsPlace], units: UnitSet) -> Compared {
    let summaries: Vec<Option<Value>> = places.iter().map(|place| summary(&place.path)).collect();
    let settings: Vec<Option<&Value>> = summaries
        .iter()
        .map(|parsed| parsed.as_ref().map(|summary| &summary["settings"]))
        .collect();
    let mut rows: Vec<ComparedScalar> = Vec::new();
    for (place, (results, summary)) in places.iter().zip(&summaries).enumerate() {
        let Some(summary) = summary else { continue };
        for Scalar { of: scalar, label, unit, value } in scalars(&results.path, summary, units) {
            let row = rows.iter().position(|row| row.of == scalar && row.label == label);
            let row = row.unwrap_or_else(|| {
                let values = vec![None; places.len()];
                rows.push(ComparedScalar { of: scalar, label, unit, values });
                rows.len() - 1
            });
            rows[row].values[place] = Some(value);
        }
    }
    Compared {
        inputs: differing(&settings),
        scalars: rows,
        curves: places
            .iter()
            .enumerate()
            .flat_map(|(k, place)| curves(&place.path, k, units))
            .collect(),
        results: places.iter().map(ResultsEntry::of).collect(),
    }
}
