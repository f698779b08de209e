//! Margins of a reach as curves against depth.

use wholestring::operation::OperationKind;
use wholestring_judge::DepthLimit;
use wholestring_results::{ReachMargin, ReachSummary};

/// The margin of a limit against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ReachCurve {
    /// The operation.
    pub(super) operation: OperationKind,
    /// The limit.
    pub(super) limit: DepthLimit,
    /// Place of the friction.
    pub(super) friction: usize,
    /// Depth of the bit, m, and the remaining margin; not a number for a string that is locked up.
    pub(super) points: Vec<(f64, f64)>,
}

/// Curves of `reach.parquet`: rows that differ only in depth.
pub(super) fn curves(margins: &[ReachMargin], summary: &ReachSummary) -> Vec<ReachCurve> {
    let key = |row: &ReachMargin| (row.operation, row.limit, row.friction.map(f64::to_bits));
    let curve = |rows: &[ReachMargin]| {
        let first = rows.first()?;
        let place = summary.frictions.iter().position(|reach| reach.friction == first.friction);
        Some(ReachCurve {
            operation: first.operation,
            limit: first.limit,
            friction: place.unwrap_or(0),
            points: rows.iter().map(|row| (row.bit_depth_m, row.margin)).collect(),
        })
    };
    margins.chunk_by(|one, other| key(one) == key(other)).filter_map(curve).collect()
}
