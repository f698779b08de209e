//! Whole tables in a folder of results.

use std::path::Path;

use wholestring_results::{ReadRow, ResultsError, TABLES, Table};

/// A whole table of the folder with all of its declared columns; without rows if the file does not
/// exist.
///
/// # Errors
/// A file that cannot be read, or contains another table.
pub(crate) fn table(folder: &Path, name: &str) -> Result<Table, ResultsError> {
    let path = folder.join(format!("{name}.parquet"));
    if !path.is_file() {
        return Ok(Table::new(Vec::new()));
    }
    let table = Table::read_parquet(&path)?;
    match TABLES.iter().find(|(known, _)| *known == name) {
        Some((_, declared)) => table.with_declared(declared, &path),
        None => Ok(table),
    }
}

/// The rows of a whole table of the folder; none if the file does not exist.
///
/// # Errors
/// As [`table`], and a value that a row cannot have.
pub(crate) fn read_rows<R: ReadRow>(folder: &Path, name: &str) -> Result<Vec<R>, ResultsError> {
    rows_of(&table(folder, name)?, &folder.join(format!("{name}.parquet")))
}

/// The rows of a [`table`] that was read from `path`.
///
/// # Errors
/// A value that a row cannot have.
pub(crate) fn rows_of<R: ReadRow>(table: &Table, path: &Path) -> Result<Vec<R>, ResultsError> {
    match table.columns().is_empty() {
        true => Ok(Vec::new()),
        false => R::read(table, path),
    }
}
