//! Row groups of a table in files of their own, in a folder next to the table's file, until they
//! are joined there.
//!
//! A part is written once and never changed, so that a run can continue from any checkpoint that
//! was written since: it drops the younger parts, and writes the same ones again. The parts are
//! removed together with the checkpoint
//! ([`ResultsFolder::remove_checkpoint`](crate::ResultsFolder::remove_checkpoint)).

use std::{
    fs::{self, File},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
};

use parquet::{
    errors::ParquetError,
    file::{
        metadata::{ParquetMetaData, ParquetMetaDataReader},
        writer::SerializedFileWriter,
    },
};

use crate::{
    ResultsError,
    file::write_whole,
    parquet_file::{self, copy_groups, io_error},
};

/// The parts of a table.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parts<'a> {
    pub(crate) folder: &'a Path,
    /// The table's name, without the ending of its file.
    pub(crate) table: &'static str,
}

impl Parts<'_> {
    /// `frames.parts/000001.parquet`: numbered so that names sort in order of writing.
    pub(crate) fn path(&self, number: usize) -> PathBuf {
        self.place().join(format!("{number:06}.parquet"))
    }

    fn place(&self) -> PathBuf {
        self.folder.join(format!("{}.parts", self.table))
    }

    /// Writes a part.
    pub(crate) fn write(
        &self,
        number: usize,
        write: impl FnOnce(&mut BufWriter<File>) -> Result<(), ParquetError>,
    ) -> Result<(), ResultsError> {
        let place = self.place();
        fs::create_dir_all(&place)
            .map_err(|source| ResultsError::Folder { path: place, source })?;
        write_whole(&self.path(number), |writer| write(writer).map_err(io_error))
    }

    /// Opens a part: a Parquet file with a row group.
    pub(crate) fn open(&self, number: usize) -> Result<Part, ResultsError> {
        let path = self.path(number);
        let file = parquet_file::open(&path)?;
        let metadata =
            parquet_file::guarded(&path, || ParquetMetaDataReader::new().parse_and_finish(&file))?;
        Ok(Part { file, metadata })
    }

    /// Copies parts into a file without unpacking them.
    pub(crate) fn copy<W: Write + Send>(
        &self,
        numbers: impl Iterator<Item = usize>,
        file: &mut SerializedFileWriter<W>,
    ) -> Result<(), ParquetError> {
        for number in numbers {
            let part = self.open(number);
            let part = part.map_err(|error| ParquetError::External(error.into()))?;
            copy_groups(&part.file, &part.metadata, usize::MAX, file)?;
        }
        Ok(())
    }

    /// Removes all parts but the first `count`, and with the last of them their folder.
    pub(crate) fn remove(&self, count: usize) -> Result<(), ResultsError> {
        let place = self.place();
        let remove = || -> io::Result<()> {
            if count == 0 {
                return fs::remove_dir_all(&place);
            }
            let remaining: Vec<PathBuf> = (1..=count).map(|number| self.path(number)).collect();
            for entry in fs::read_dir(&place)? {
                let path = entry?.path();
                if !remaining.contains(&path) {
                    fs::remove_file(path)?;
                }
            }
            Ok(())
        };
        match remove() {
            Err(source) if source.kind() != io::ErrorKind::NotFound => {
                Err(ResultsError::Write { path: place, source })
            }
            _ => Ok(()),
        }
    }
}

/// A part on the disk.
pub(crate) struct Part {
    pub(crate) file: File,
    pub(crate) metadata: ParquetMetaData,
}
