//! Margins of a reach as curves against depth.

use std::path::Path;

use wholestring::operation::OperationKind;
use wholestring_results::{ReachSummary, ResultsError, Table};

/// The margin of a limit against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ReachCurve {
    /// The operation.
    pub(super) operation: OperationKind,
    /// The limit, as shown to users.
    pub(super) limit: String,
    /// Place of the friction.
    pub(super) friction: usize,
    /// Depth of the bit, m, and the remaining margin; not a number for a string that is locked up.
    pub(super) points: Vec<(f64, f64)>,
}

/// Curves of `reach.parquet`: rows that differ only in depth.
pub(super) fn curves(
    table: &Table,
    path: &Path,
    summary: &ReachSummary,
) -> Result<Vec<ReachCurve>, ResultsError> {
    let words = |name| table.words(name).unwrap_or_default();
    let numbers = |name| table.numbers(name).unwrap_or_default();
    let (operations, limit) = (words("operation"), words("limit"));
    let friction = numbers("friction");
    let (depth_m, margin) = (numbers("bit_depth_m"), numbers("margin"));
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let mut curves: Vec<ReachCurve> = Vec::new();
    let mut last = None;
    for row in 0..operations.len().min(limit.len()).min(margin.len()) {
        let key = (&operations[row], &limit[row], friction[row].map(f64::to_bits));
        if last != Some(key) {
            let place = summary.frictions.iter().position(|reach| reach.friction == friction[row]);
            let mut titled = summary.frictions.iter().flat_map(|friction| &friction.limits);
            let title = titled.find(|titled| titled.limit == limit[row]);
            curves.push(ReachCurve {
                operation: table.operation(row, path)?,
                limit: title.map_or_else(|| limit[row].clone(), |title| title.title.clone()),
                friction: place.unwrap_or(0),
                points: Vec::new(),
            });
            last = Some(key);
        }
        if let Some(curve) = curves.last_mut() {
            curve.points.push((number(depth_m[row]), number(margin[row])));
        }
    }
    Ok(curves)
}
