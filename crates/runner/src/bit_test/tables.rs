//! The tables of a bit test.

use wholestring::rock::{TrialOutcome, bit_face::BottomHole};
use wholestring_results::{
    BIT_TEST, BOTTOM_HOLE, BitTestPoint, Column, Data, ResultsError, ResultsFolder, Status, Table,
};

use super::points::rpm;
use crate::record::rows::bottom_rows;

/// Name of the table of all points, without its extension.
pub(super) const POINTS: &str = "bit-test";

/// Name of the table of a point's bottom, without its extension, and what it has for an operation.
pub(super) const BOTTOM: &str = "bottom_hole";
pub(super) const OPERATION: &str = "bit_test";

/// Name of the table for the law "table".
const LAW: &str = "bit-table.csv";

/// A number of an outcome.
type Number = (&'static str, fn(&TrialOutcome) -> f64);

/// The numbers of a finished point, as its columns are called.
const NUMBERS: [Number; 15] = [
    ("rate_of_penetration_m_per_s", |of| of.rate_of_penetration_m_per_s),
    ("rate_of_penetration_error_m_per_s", |of| or_nan(of.rate_of_penetration_error_m_per_s)),
    ("depth_of_cut_m", |of| of.depth_of_cut_m),
    ("torque_N_m", |of| of.torque_N_m),
    ("torque_error_N_m", |of| or_nan(of.torque_error_N_m)),
    ("torque_std_N_m", |of| of.torque_std_N_m),
    ("weight_borne_N", |of| of.weight_borne_N),
    ("weight_on_bit_std_N", |of| of.weight_on_bit_std_N),
    ("specific_energy_Pa", |of| or_nan(of.specific_energy_Pa)),
    ("mechanical_specific_energy_Pa", |of| or_nan(of.mechanical_specific_energy_Pa)),
    ("bricks_broken", |of| of.bricks_broken as f64),
    ("kinetic_fraction", |of| of.kinetic_fraction),
    ("revolutions", |of| of.revolutions),
    ("time_s", |of| of.time_s),
    ("averaging_time_s", |of| of.averaging_time_s),
];

fn or_nan(number: Option<f64>) -> f64 {
    number.unwrap_or(f64::NAN)
}

/// A row for each point, finished or not.
pub(super) fn points(points: &[BitTestPoint]) -> Table {
    let mut table = Table::with_columns(BIT_TEST);
    for point in points {
        let (status, message) = match &point.status {
            Status::Complete => ("complete", ""),
            Status::Interrupted => ("interrupted", ""),
            Status::Failed(reason) => ("failed", reason.as_str()),
        };
        let number = |of: fn(&TrialOutcome) -> f64| point.outcome.as_ref().map_or(f64::NAN, of);
        let mut numbers: Vec<(&str, [f64; 1])> = vec![
            ("weight_on_bit_N", [point.weight_on_bit_N]),
            ("rotary_speed_rad_per_s", [point.rotary_speed_rad_per_s]),
        ];
        numbers.extend(NUMBERS.map(|(name, of)| (name, [number(of)])));
        let numbers: Vec<(&str, &[f64])> =
            numbers.iter().map(|(name, number)| (*name, &number[..])).collect();
        table.append(
            &[("point", &[&point.point]), ("status", &[status]), ("message", &[message])],
            &numbers,
        );
    }
    table
}

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
    let column = |(name, of): Number| Column {
        name: name.to_owned(),
        unit: String::new(),
        meaning: String::new(),
        data: Data::Number(outcomes.iter().map(|outcome| Some(of(outcome))).collect()),
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
