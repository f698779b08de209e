//! The tables of a bit test.

use wholestring::rock::{TrialOutcome, bit_face::BottomHole};
use wholestring_results::{
    BitTestPoint, BottomHoleCell, Column, ResultsError, ResultsFolder, Row as _, Table,
};

use super::points::rpm;
use crate::record::rows::bottom_cells;

/// Name of the table of all points, without its extension.
pub(super) const POINTS: &str = "bit-test";

/// Name of the table of a point's bottom hole, without its extension, and the name of its
/// operation.
pub(super) const BOTTOM: &str = "bottom_hole";
const OPERATION: &str = "bit_test";

/// Name of the table for the law "table".
pub(super) const LAW: &str = "bit-table.csv";

/// A number of an outcome.
type Number = (&'static str, fn(&TrialOutcome) -> f64);

/// Writes the table for the law "table" if every point is finished; otherwise removes that of an
/// earlier test.
pub(super) fn write_law(
    folder: &ResultsFolder,
    points: &[BitTestPoint],
) -> Result<(), ResultsError> {
    let outcomes: Option<Vec<TrialOutcome>> = points.iter().map(|point| point.outcome).collect();
    match outcomes {
        Some(outcomes) => law(&outcomes).write_csv(&folder.path().join(LAW)),
        None => folder.remove(LAW),
    }
}

/// The columns that `[bit.table] file` requires.
fn law(outcomes: &[TrialOutcome]) -> Table {
    // A bit that bounces on rock that it does not break may end slightly higher, but a law contains
    // no negative numbers.
    let columns: [Number; 6] = [
        ("weight_on_bit_N", |outcome| outcome.weight_on_bit_N),
        ("rotary_speed_rpm", |outcome| rpm(outcome.rotary_speed_rad_per_s)),
        ("rate_of_penetration_m_per_h", |outcome| {
            3600.0 * outcome.rate_of_penetration_m_per_s.max(0.0)
        }),
        ("torque_N_m", |outcome| outcome.torque_N_m.max(0.0)),
        ("torque_std_N_m", |outcome| outcome.torque_std_N_m),
        ("weight_on_bit_std_N", |outcome| outcome.weight_on_bit_std_N),
    ];
    let column = |(name, value_of): Number| {
        Column::numbers(name, outcomes.iter().map(|outcome| Some(value_of(outcome))).collect())
    };
    Table::new(columns.map(column).into())
}

/// The bottom hole left by a point, as for a run.
pub(super) fn bottom(bottom: &BottomHole) -> Table {
    BottomHoleCell::table(bottom_cells(bottom, OPERATION))
}
