//! Columns of tables by their name.

use std::path::Path;

use wholestring::operation::OperationKind;
use wholestring_results::{ResultsError, Table};

/// Numbers of a column; empty if the table has no numeric column of that name.
pub(crate) fn numbers<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    table.numbers(name).unwrap_or_default()
}

/// The operation that a row of a table names, or an error with the file of the table.
pub(crate) fn operation(
    table: &Table,
    row: usize,
    path: &Path,
) -> Result<OperationKind, ResultsError> {
    let name = words(table, "operation").get(row).map_or("", String::as_str);
    OperationKind::from_name(name).ok_or_else(|| ResultsError::Format {
        path: path.to_owned(),
        reason: format!("'{name}' in row {} is no operation", row + 1),
    })
}

/// Words of a column; empty if the table has no text column of that name.
pub(crate) fn words<'a>(table: &'a Table, name: &str) -> &'a [String] {
    table.words(name).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use wholestring_results::Column;

    use super::*;

    #[test]
    fn a_name_of_no_operation_is_an_error() {
        let names = ["drill", "trip"].map(str::to_owned);
        let table = Table::new(vec![Column::words("operation", names.into())]);
        let found = |row| operation(&table, row, Path::new("reach.parquet"));
        assert_eq!(found(0).expect("an operation"), OperationKind::Drill);
        let error = found(1).expect_err("no operation").to_string();
        assert!(error.contains("reach.parquet") && error.contains("'trip' in row 2"), "{error}");
    }
}
