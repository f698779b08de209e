//! Operations that the rows of a table name.

use std::path::Path;

use wholestring::operation::OperationKind;

use crate::{ResultsError, Table};

impl Table {
    /// The operation that a row of the column `operation` names, or an error with the file of the
    /// table.
    pub fn operation(&self, row: usize, path: &Path) -> Result<OperationKind, ResultsError> {
        let words = self.words("operation").unwrap_or_default();
        let name = words.get(row).map_or("", String::as_str);
        OperationKind::from_name(name).ok_or_else(|| ResultsError::Format {
            path: path.to_owned(),
            reason: format!("'{name}' in row {} is no operation", row + 1),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Column;

    #[test]
    fn a_name_of_no_operation_is_an_error() {
        let names = ["drill", "trip"].map(str::to_owned);
        let table = Table::new(vec![Column::words("operation", names.into())]);
        let found = |row| table.operation(row, Path::new("reach.parquet"));
        assert_eq!(found(0).expect("an operation"), OperationKind::Drill);
        let error = found(1).expect_err("no operation").to_string();
        assert!(error.contains("reach.parquet") && error.contains("'trip' in row 2"), "{error}");
    }
}
