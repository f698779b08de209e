//! Columns of tables by their name.

use wholestring_results::Table;

/// The numbers of a column; none where the table has no such column of numbers.
pub(crate) fn numbers<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    table.numbers(name).unwrap_or_default()
}

/// The words of a column; none where the table has no such column of words.
pub(crate) fn words<'a>(table: &'a Table, name: &str) -> &'a [String] {
    table.words(name).unwrap_or_default()
}
