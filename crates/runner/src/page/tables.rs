//! The tables of a run as its page reads them.

use std::path::{Path, PathBuf};

use wholestring_results::{ResultsError, Table};

/// The tables of a run, without rows where there is none. Those against time are large, and are
/// read operation by operation.
pub(crate) struct Tables {
    folder: PathBuf,
    pub(super) nodes: Table,
    pub(super) wear: Table,
    pub(super) bottom_hole: Table,
}

impl Tables {
    /// Those in a folder.
    pub(crate) fn read(folder: &Path) -> Result<Self, ResultsError> {
        Ok(Self {
            folder: folder.to_owned(),
            nodes: table(folder, "nodes")?,
            wear: table(folder, "wear")?,
            bottom_hole: table(folder, "bottom_hole")?,
        })
    }

    /// A table against time, as far as it is about an operation.
    pub(super) fn of(&self, name: &str, operation: &str) -> Result<Table, ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        let rows = if path.is_file() {
            Table::read_parquet_with(&path, "operation", operation)?
        } else {
            None
        };
        Ok(rows.unwrap_or_else(|| Table::new(Vec::new())))
    }
}

/// A table of the folder, without rows where there is none.
pub(crate) fn table(folder: &Path, name: &str) -> Result<Table, ResultsError> {
    let path = folder.join(format!("{name}.parquet"));
    if path.is_file() {
        Table::read_parquet(&path)
    } else {
        Ok(Table::new(Vec::new()))
    }
}
