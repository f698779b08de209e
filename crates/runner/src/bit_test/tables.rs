//! The tables of a bit test.

use wholestring::rock::{TrialOutcome, bit_face::BottomHole};
use wholestring_results::{BOTTOM_HOLE, BitTestPoint, Column, ResultsError, ResultsFolder, Table};

use super::points::rpm;
use crate::record::rows::bottom_rows;

/// Name of the table of all points, without its extension.
pub(super) const POINTS: &str = "bit-test";

/// Name of the table of a point's bottom, without its extension, and what it has for an operation.
pub(super) const BOTTOM: &str = "bottom_hole";
pub(super) const OPERATION: &str = "bit_test";

/// Name of the table for the law "table".
pub(super) const LAW: &str = "bit-table.csv";

/// A number of an outcome.
type Number = (&'static str, fn(&TrialOutcome) -> f64);

/// Writes the table for the law "table", where every point is finished; where not, that of an
/// earlier test goes.
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

/// The columns that `[bit.table] file` reads.
fn law(outcomes: &[TrialOutcome]) -> Table {
    // A bit that hops on rock that it does not break may end a little higher; a law has nothing
    // below zero.
    let columns: [Number; 6] = [
        ("weight_on_bit_N", |of| of.weight_on_bit_N),
        ("rotary_speed_rpm", |of| rpm(of.rotary_speed_rad_per_s)),
        ("rate_of_penetration_m_per_h", |of| 3600.0 * of.rate_of_penetration_m_per_s.max(0.0)),
        ("torque_N_m", |of| of.torque_N_m.max(0.0)),
        ("torque_std_N_m", |of| of.torque_std_N_m),
        ("weight_on_bit_std_N", |of| of.weight_on_bit_std_N),
    ];
    let column = |(name, of): Number| {
        Column::numbers(name, outcomes.iter().map(|outcome| Some(of(outcome))).collect())
    };
    Table::new(columns.map(column).into())
}

/// The bottom that a point has left, as a run's.
pub(super) fn bottom(bottom: &BottomHole) -> Table {
    let mut table = Table::with_columns(BOTTOM_HOLE);
    let [radius_m, angle_rad, depth_m] = &bottom_rows(bottom);
    table.append(
        &[("operation", &[OPERATION])],
        &[("radius_m", radius_m), ("angle_rad", angle_rad), ("depth_m", depth_m)],
    );
    table
}
