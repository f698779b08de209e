//! A table that a run adds to: what was written stays on the disk, so that memory does not grow
//! with the operations.

use std::{
    borrow::Cow,
    fs::File,
    path::{Path, PathBuf},
};

use parquet::file::metadata::{ParquetMetaData, ParquetMetaDataReader};
use serde::{Deserialize, Serialize};
use wholestring::outcome::{self, ModelKind};

use crate::{
    ColumnSpec, ResultsError, ResultsFolder, Table, file::write_whole, names::CHECKPOINT,
    parquet_file,
};

/// A table of a run. Rows gather in memory until [`GrowingTable::write`] puts them behind those of
/// the file, as a row group of their own.
#[derive(Debug, Clone)]
pub struct GrowingTable {
    name: &'static str,
    columns: &'static [ColumnSpec],
    /// Row groups of the file that are the run's.
    groups: usize,
    waiting: Table,
    /// Whether the file holds them all.
    written: bool,
}

/// A growing table as a checkpoint keeps it: the rows that wait, and how many groups are on the
/// disk.
#[derive(Debug, Serialize, Deserialize)]
pub struct TableSoFar<'a> {
    groups: usize,
    waiting: Cow<'a, Table>,
}

impl GrowingTable {
    /// A table without rows; what an earlier run left in a file of that name goes with the first
    /// [`GrowingTable::write`].
    pub fn begin(name: &'static str, columns: &'static [ColumnSpec]) -> Self {
        Self { name, columns, groups: 0, waiting: Table::with_columns(columns), written: false }
    }

    /// Holds these rows in place of those that it has, of a table that was never written; tells
    /// whether they have its columns.
    #[must_use]
    pub fn take(&mut self, rows: Table) -> bool {
        let is_like = self.groups == 0 && rows.is_like(&self.waiting);
        if is_like {
            self.waiting = rows;
            self.written = false;
        }
        is_like
    }

    /// Name of its files, without their ending.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The rows in memory: all of a table that was never written.
    pub fn rows(&self) -> &Table {
        &self.waiting
    }

    /// Resumes a table from a checkpoint and from what the folder holds of it; rows written since
    /// are removed.
    ///
    /// # Errors
    /// A checkpoint with other columns, and a file that is missing, damaged, has other columns, or
    /// fewer row groups than there were.
    pub fn resume(
        &mut self,
        folder: &ResultsFolder,
        so_far: TableSoFar<'_>,
    ) -> Result<(), ResultsError> {
        let empty = Table::with_columns(self.columns);
        if !so_far.waiting.is_like(&empty) {
            return Err(ResultsError::Checkpoint {
                path: folder.path().join(CHECKPOINT),
                reason: format!("it is damaged (its table `{}`)", self.name),
            });
        }
        if so_far.groups > 0 {
            let path = self.path(folder);
            let (_, metadata) = open(&path)?;
            let there = metadata.num_row_groups();
            let fields = metadata.file_metadata().schema_descr().columns().iter();
            let wanted = self.columns.iter().map(|column| column.name);
            if there < so_far.groups || !fields.map(|field| field.name()).eq(wanted) {
                let reason = "it is not what the run that is to be resumed had written";
                return Err(ResultsError::format(&path, reason));
            }
        }
        self.groups = so_far.groups;
        self.waiting = so_far.waiting.into_owned();
        self.written = false;
        Ok(())
    }

    /// Adds rows, as [`Table::append`] does.
    pub fn append(&mut self, words: &[(&str, &[&str])], numbers: &[(&str, &[f64])]) {
        self.waiting.append(words, numbers);
        self.written = false;
    }

    /// Adds rows, as [`Table::append_declared`] does.
    pub fn append_declared<T>(
        &mut self,
        words: &[(&str, &[&str])],
        declared: &[outcome::Column<T>],
        of: &T,
        model: ModelKind,
    ) {
        self.waiting.append_declared(words, declared, of, model);
        self.written = false;
    }

    /// What a checkpoint must keep, to continue from here.
    pub fn so_far(&self) -> TableSoFar<'_> {
        TableSoFar { groups: self.groups, waiting: Cow::Borrowed(&self.waiting) }
    }

    /// Writes `<name>.parquet` with all rows so far, and `<name>.csv` where `csv` requires it.
    /// Their bytes depend on the rows and on what was written together, not on where a run was
    /// taken up.
    ///
    /// # Errors
    /// A file that cannot be written, or whose earlier rows cannot be read.
    pub fn write(&mut self, folder: &ResultsFolder, csv: bool) -> Result<(), ResultsError> {
        let path = self.path(folder);
        let csv_name = format!("{}.csv", self.name);
        if !self.written {
            let earlier = match self.groups {
                0 => None,
                _ => Some(open(&path)?),
            };
            write_whole(&path, |writer| {
                // Closed before the new file takes its name: Windows may not replace an open one.
                let earlier = earlier;
                let write = || {
                    let mut file = parquet_file::begin(&self.waiting, writer)?;
                    if let Some((file_before, metadata)) = &earlier {
                        parquet_file::copy_groups(file_before, metadata, self.groups, &mut file)?;
                    }
                    if self.waiting.rows() > 0 {
                        parquet_file::write_group(&self.waiting, &mut file)?;
                    }
                    file.close().map(drop)
                };
                write().map_err(parquet_file::io_error)
            })?;
            if self.waiting.rows() > 0 {
                self.groups += 1;
                self.waiting = Table::with_columns(self.columns);
            }
            self.written = true;
        }
        if !csv {
            return folder.remove(&csv_name);
        }
        let path_csv = folder.path().join(&csv_name);
        Table::write_csv_pieces(&path_csv, &self.waiting, |take| {
            parquet_file::read_each_group(&path, take)
        })
    }

    /// Leaves the table out of the folder: what an earlier run left of it goes. The rows stay in
    /// memory, and those that a checkpoint counts on stay in their file.
    ///
    /// # Errors
    /// A file that cannot be removed.
    pub fn leave_out(&self, folder: &ResultsFolder) -> Result<(), ResultsError> {
        if self.groups == 0 {
            folder.remove(&format!("{}.parquet", self.name))?;
        }
        folder.remove(&format!("{}.csv", self.name))
    }

    fn path(&self, folder: &ResultsFolder) -> PathBuf {
        folder.path().join(format!("{}.parquet", self.name))
    }
}

fn open(path: &Path) -> Result<(File, ParquetMetaData), ResultsError> {
    let file = parquet_file::open(path)?;
    let metadata =
        parquet_file::guarded(path, || ParquetMetaDataReader::new().parse_and_finish(&file))?;
    Ok((file, metadata))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CONTACT, TIME};

    fn append(table: &mut GrowingTable, operation: &str, from: f64) {
        let numbers = [from, from + 1.0, f64::NAN];
        table.append(&[("operation", &[operation])], &[("time_s", &numbers), ("md_m", &numbers)]);
    }

    fn all(folder: &ResultsFolder) -> (Vec<u8>, Vec<u8>, Table) {
        let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
        let table = Table::read_parquet(&folder.path().join("contact.parquet")).unwrap();
        (read("contact.parquet"), read("contact.csv"), table)
    }

    fn folder() -> (tempfile::TempDir, ResultsFolder) {
        let place = tempfile::tempdir().unwrap();
        let folder = ResultsFolder::create(place.path()).unwrap();
        (place, folder)
    }

    /// As one table that is held as a whole.
    #[test]
    fn rows_that_came_in_parts_are_those_of_one_table() {
        let (_place, folder) = folder();
        // What an earlier run left is none of it.
        let mut table = GrowingTable::begin("contact", CONTACT);
        append(&mut table, "earlier", 100.0);
        table.write(&folder, true).unwrap();
        let mut table = GrowingTable::begin("contact", CONTACT);
        table.write(&folder, true).unwrap();
        assert_eq!(all(&folder).2.rows(), 0);
        let mut whole = Table::with_columns(CONTACT);
        for (operation, from) in [("trip_in", 1.0), ("drill", 5.0), ("slide", 9.0)] {
            append(&mut table, operation, from);
            let numbers = [from, from + 1.0, f64::NAN];
            whole.append(
                &[("operation", &[operation])],
                &[("time_s", &numbers), ("md_m", &numbers)],
            );
            table.write(&folder, true).unwrap();
            assert_eq!(table.waiting.rows(), 0);
        }
        let (_, csv, read) = all(&folder);
        assert_eq!(read, whole);
        whole.write_csv(&folder.path().join("whole.csv")).unwrap();
        assert_eq!(csv, std::fs::read(folder.path().join("whole.csv")).unwrap());
        table.write(&folder, false).unwrap();
        assert!(!folder.path().join("contact.csv").exists());
    }

    /// A run that was killed after it had written more than its checkpoint knows of writes the same
    /// again.
    #[test]
    fn a_resumed_table_has_the_same_bytes() {
        let (_place, folder) = folder();
        let mut table = GrowingTable::begin("contact", CONTACT);
        append(&mut table, "trip_in", 1.0);
        table.write(&folder, true).unwrap();
        append(&mut table, "drill", 5.0);
        let kept = postcard::to_stdvec(&table.so_far()).unwrap();
        table.write(&folder, true).unwrap();
        append(&mut table, "slide", 9.0);
        table.write(&folder, true).unwrap();
        let whole = all(&folder);
        let so_far: TableSoFar = postcard::from_bytes(&kept).unwrap();
        let mut resumed = GrowingTable::begin("contact", CONTACT);
        resumed.resume(&folder, so_far).unwrap();
        resumed.write(&folder, true).unwrap();
        assert_eq!(all(&folder).2.rows(), 6);
        append(&mut resumed, "slide", 9.0);
        resumed.write(&folder, true).unwrap();
        assert!(all(&folder) == whole);
        // A file without the rows that it had is reported.
        let path = folder.path().join("contact.parquet");
        let refused = |kept: &[u8], what: &str| {
            let so_far = postcard::from_bytes(kept).unwrap();
            let mut table = GrowingTable::begin("contact", CONTACT);
            let error = table.resume(&folder, so_far).unwrap_err().to_string();
            assert!(error.contains(what), "{error}");
        };
        GrowingTable::begin("contact", CONTACT).write(&folder, false).unwrap();
        refused(&kept, "contact.parquet is not a file of results");
        Table::with_columns(TIME).write_parquet(&path).unwrap();
        refused(&kept, "contact.parquet is not a file of results");
        std::fs::write(&path, "PAR1").unwrap();
        refused(&kept, "contact.parquet is not a file of results");
        std::fs::remove_file(&path).unwrap();
        refused(&kept, "contact.parquet");
        let other = GrowingTable::begin("contact", TIME);
        let other = postcard::to_stdvec(&other.so_far()).unwrap();
        refused(&other, "its table `contact`");
    }

    /// A run that is to leave no table keeps its rows in memory, but not without those that a
    /// checkpoint of a run that was to leave one counts on.
    #[test]
    fn a_table_that_is_left_out_can_still_be_resumed() {
        let (_place, folder) = folder();
        let there = || folder.path().join("contact.parquet").exists();
        let mut table = GrowingTable::begin("contact", CONTACT);
        append(&mut table, "trip_in", 1.0);
        table.write(&folder, true).unwrap();
        let kept = postcard::to_stdvec(&table.so_far()).unwrap();
        let mut resumed = GrowingTable::begin("contact", CONTACT);
        resumed.resume(&folder, postcard::from_bytes(&kept).unwrap()).unwrap();
        append(&mut resumed, "drill", 5.0);
        resumed.leave_out(&folder).unwrap();
        assert!(there() && !folder.path().join("contact.csv").exists());
        append(&mut table, "drill", 5.0);
        table.write(&folder, true).unwrap();
        let whole = all(&folder);
        resumed.write(&folder, true).unwrap();
        assert!(all(&folder) == whole);
        // One that begins anew needs nothing of what is there.
        let mut table = GrowingTable::begin("contact", CONTACT);
        append(&mut table, "drill", 5.0);
        table.leave_out(&folder).unwrap();
        assert!(!there());
        assert_eq!(table.waiting.rows(), 3);
    }
}
