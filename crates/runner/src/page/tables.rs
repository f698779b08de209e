//! Tables of a run for its page.

use std::path::{Path, PathBuf};

use wholestring::operation::OperationKind;
use wholestring_results::{ReadRow, ResultsError, TABLES, Table};

/// The tables of a run. They are large and are read operation by operation.
pub(crate) struct Tables {
    folder: PathBuf,
}

impl Tables {
    /// Tables in a folder.
    pub(crate) fn of_folder(folder: &Path) -> Self {
        Self { folder: folder.to_owned() }
    }

    /// The part of a table for an operation; without rows if there is none.
    pub(super) fn of(&self, name: &str, operation: OperationKind) -> Result<Table, ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        let rows = if path.is_file() {
            Table::read_parquet_with(&path, "operation", operation.name())?
        } else {
            None
        };
        Ok(rows.unwrap_or_else(|| Table::new(Vec::new())))
    }
}

impl Tables {
    /// Calls `take` with the pieces of a table that contain rows of an operation, possibly with
    /// others, for tables that exceed the memory.
    pub(super) fn pieces_of(
        &self,
        name: &str,
        operation: OperationKind,
        take: impl FnMut(Table),
    ) -> Result<(), ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        match path.is_file() {
            true => Table::read_parquet_pieces_with(&path, "operation", operation.name(), take),
            false => Ok(()),
        }
    }

    /// The same for some columns only, with all pieces of the table.
    pub(super) fn columns_of(
        &self,
        name: &str,
        columns: &[&str],
        take: impl FnMut(Table),
    ) -> Result<(), ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        match path.is_file() {
            true => Table::read_parquet_pieces(&path, columns, take),
            false => Ok(()),
        }
    }
}

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
