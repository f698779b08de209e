//! Columns of tables by their name.

use wholestring_results::Table;

/// Numbers of a column; empty if the table has no numeric column of that name.
pub(crate) fn numbers<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    table.numbers(name).unwrap_or_default()
}

/// Words of a column; empty if the table has no text column of that name.
pub(crate) fn words<'a>(table: &'a Table, name: &str) -> &'a [String] {
    table.words(name).unwrap_or_default()
}
