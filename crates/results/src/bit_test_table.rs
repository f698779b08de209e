//! `bit-test.parquet`: a row for each point of a bit test.

use crate::{BIT_TEST, BitTestPoint, Status, Table, columns::bit_test_numbers};

/// A row for each point, finished or not.
pub fn bit_test_table(points: &[BitTestPoint]) -> Table {
    let mut table = Table::with_columns(BIT_TEST);
    for point in points {
        let (status, message) = match &point.status {
            Status::Complete => ("complete", ""),
            Status::Interrupted => ("interrupted", ""),
            Status::Failed(reason) => ("failed", reason.as_str()),
        };
        let numbers: Vec<(&str, [f64; 1])> = bit_test_numbers()
            .map(|column| (column.spec.name, [(column.value)(point).unwrap_or(f64::NAN)]))
            .collect();
        let numbers: Vec<(&str, &[f64])> =
            numbers.iter().map(|(name, number)| (*name, &number[..])).collect();
        table.append(
            &[("point", &[&point.point]), ("status", &[status]), ("message", &[message])],
            &numbers,
        );
    }
    table
}
