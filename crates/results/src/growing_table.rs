//! A table that a run adds to. Written rows stay on the disk, so that memory grows neither with the
//! number of operations nor with their length.

use std::{
    borrow::Cow,
    fs::File,
    path::{Path, PathBuf},
};

use parquet::file::metadata::{ParquetMetaData, ParquetMetaDataReader};
use serde::{Deserialize, Serialize};
use wholestring::outcome::{self, ModelKind};

use crate::{
    ColumnSpec, ResultsError, ResultsFolder, Row, Table, file::write_whole, names::CHECKPOINT,
    parquet_file, parts::Parts,
};

/// A table of a run. Rows are collected in memory until [`GrowingTable::write`] appends them to
/// those of the file, as a row group of their own; rows that are too many for memory are written to
/// the disk as parts ([`GrowingTable::append_part`]), which the next write joins to the file.
#[derive(Debug, Clone)]
pub struct GrowingTable {
    name: &'static str,
    columns: &'static [ColumnSpec],
    /// Row groups of the file that belong to the run.
    groups: usize,
    /// Parts on the disk, and the number of them, from the first, that are among those groups.
    parts: usize,
    joined: usize,
    waiting: Table,
    /// Whether the file has them all.
    written: bool,
}

/// A growing table as stored in a checkpoint: the waiting rows and the numbers of groups and parts
/// on the disk.
#[derive(Debug, Serialize, Deserialize)]
pub struct TableSoFar<'a> {
    groups: usize,
    parts: usize,
    joined: usize,
    waiting: Cow<'a, Table>,
}

impl GrowingTable {
    /// A table without rows; a file of that name from an earlier run is removed by the first
    /// [`GrowingTable::write`].
    pub fn begin(name: &'static str, columns: &'static [ColumnSpec]) -> Self {
        let waiting = Table::with_columns(columns);
        Self { name, columns, groups: 0, parts: 0, joined: 0, waiting, written: false }
    }

    /// Replaces the rows of a table that was never written; returns whether the new rows have its
    /// columns.
    #[must_use]
    pub fn take(&mut self, rows: Table) -> bool {
        let is_like = self.groups == 0 && self.parts == 0 && rows.is_like(&self.waiting);
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

    /// Resumes a table from a checkpoint and from its files in the folder; rows written since are
    /// removed.
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
        if !so_far.waiting.is_like(&empty) || so_far.joined > so_far.parts {
            return Err(ResultsError::Checkpoint {
                path: folder.path().join(CHECKPOINT),
                reason: format!("it is damaged (its table `{}`)", self.name),
            });
        }
        if so_far.groups > 0 {
            let path = self.path(folder);
            let (_, metadata) = open(&path)?;
            self.check_stored(&path, &metadata, so_far.groups)?;
        }
        let parts = self.parts_in(folder);
        for number in so_far.joined + 1..=so_far.parts {
            self.check_stored(&parts.path(number), &parts.open(number)?.metadata, 1)?;
        }
        parts.remove(so_far.parts)?;
        self.groups = so_far.groups;
        self.parts = so_far.parts;
        self.joined = so_far.joined;
        self.waiting = so_far.waiting.into_owned();
        self.written = false;
        Ok(())
    }

    /// Returns an error where a file has fewer row groups than it had, or other columns.
    fn check_stored(
        &self,
        path: &Path,
        metadata: &ParquetMetaData,
        groups: usize,
    ) -> Result<(), ResultsError> {
        let fields = metadata.file_metadata().schema_descr().columns().iter();
        let expected = self.columns.iter().map(|column| column.name);
        if metadata.num_row_groups() < groups || !fields.map(|field| field.name()).eq(expected) {
            let reason = "it does not match the rows that the run to be resumed had written";
            return Err(ResultsError::format(path, reason));
        }
        Ok(())
    }

    /// Adds rows that are written to the disk at once, as a part: `add` appends them to an empty
    /// table. Waiting rows become a part before them.
    ///
    /// # Errors
    /// A part that cannot be written; its rows are then not in the table.
    pub fn append_part(
        &mut self,
        folder: &ResultsFolder,
        add: impl FnOnce(&mut Table),
    ) -> Result<(), ResultsError> {
        if self.waiting.rows() > 0 {
            self.write_part(folder, &self.waiting)?;
            self.parts += 1;
            self.waiting = Table::with_columns(self.columns);
        }
        let mut rows = Table::with_columns(self.columns);
        add(&mut rows);
        self.write_part(folder, &rows)?;
        self.parts += 1;
        self.written = false;
        Ok(())
    }

    fn write_part(&self, folder: &ResultsFolder, rows: &Table) -> Result<(), ResultsError> {
        self.parts_in(folder).write(self.parts + 1, |writer| {
            let mut file = parquet_file::begin(rows, writer)?;
            parquet_file::write_group(rows, &mut file)?;
            file.close().map(drop)
        })
    }

    /// Number of the last part, counted from one, and the number of parts that no write has joined
    /// yet.
    pub fn last_part(&self) -> (usize, usize) {
        (self.parts, self.parts - self.joined)
    }

    /// Path of a part.
    pub fn part_path(&self, folder: &ResultsFolder, number: usize) -> PathBuf {
        self.parts_in(folder).path(number)
    }

    /// Adds rows, as [`Row::append_to`] does.
    pub fn append_rows<R: Row>(&mut self, rows: impl IntoIterator<Item = R>) {
        R::append_to(&mut self.waiting, rows);
        self.written = false;
    }

    /// Adds rows, as [`Table::append_declared`] does.
    pub fn append_declared<T>(
        &mut self,
        words: &[(&str, &[&str])],
        declared: &[outcome::Column<T>],
        answer: &T,
        model: ModelKind,
    ) {
        self.waiting.append_declared(words, declared, answer, model);
        self.written = false;
    }

    /// Returns the data that a checkpoint must store to continue from here.
    pub fn so_far(&self) -> TableSoFar<'_> {
        TableSoFar {
            groups: self.groups,
            parts: self.parts,
            joined: self.joined,
            waiting: Cow::Borrowed(&self.waiting),
        }
    }

    /// Writes `<name>.parquet` with all rows so far, and `<name>.csv` where `csv` requires it.
    /// Their bytes depend on the rows and on the grouping of the writes, not on where a run was
    /// resumed.
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
            let parts = self.parts_in(folder);
            write_whole(&path, |writer| {
                // Closed before the new file takes its name: Windows may not replace an open one.
                let earlier = earlier;
                let write = || {
                    let mut file = parquet_file::begin(&self.waiting, writer)?;
                    if let Some((file_before, metadata)) = &earlier {
                        parquet_file::copy_groups(file_before, metadata, self.groups, &mut file)?;
                    }
                    parts.copy(self.joined + 1..=self.parts, &mut file)?;
                    if self.waiting.rows() > 0 {
                        parquet_file::write_group(&self.waiting, &mut file)?;
                    }
                    file.close().map(drop)
                };
                write().map_err(parquet_file::io_error)
            })?;
            self.groups += self.parts - self.joined;
            self.joined = self.parts;
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

    /// Leaves the table out of the folder: files of an earlier run are removed. The rows stay in
    /// memory, and those that a checkpoint requires stay in their file.
    ///
    /// # Errors
    /// A file that cannot be removed.
    pub fn leave_out(&self, folder: &ResultsFolder) -> Result<(), ResultsError> {
        if self.groups == 0 {
            folder.remove(&format!("{}.parquet", self.name))?;
        }
        folder.remove(&format!("{}.csv", self.name))
    }

    fn parts_in<'a>(&self, folder: &'a ResultsFolder) -> Parts<'a> {
        Parts { folder: folder.path(), table: self.name }
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
mod tests;
