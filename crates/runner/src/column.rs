//! Columns of tables by their name.

use wholestring_results::{Data, Table};

/// The numbers of a column; none where the table has no such column of numbers.
pub(crate) fn numbers<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    match table.column(name).map(|column| &column.data) {
        Some(Data::Number(values)) => values,
        _ => &[],
    }
}

/// The words of a column; none where the table has no such column of words.
pub(crate) fn words<'a>(table: &'a Table, name: &str) -> &'a [String] {
    match table.column(name).map(|column| &column.data) {
        Some(Data::Text(values)) => values,
        _ => &[],
    }
}
