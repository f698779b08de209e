//! `frames.parquet`: the whole string against time, written as it is computed, in memory that does
//! not grow with the run.

mod rows;

use std::{
    fs::{self, File},
    io::{self, BufWriter},
    path::{Path, PathBuf},
};

use parquet::{errors::ParquetError, file::writer::SerializedFileWriter};
use serde::{Deserialize, Serialize};
use wholestring::dynamics::{Channel, Frame};

use self::rows::{FrameRows, Layout};
use crate::{
    ResultsError, file::write_whole, names::CHECKPOINT, parquet_file::io_error, parts::Parts,
};

/// Writer of a Parquet file of frames.
type Writer<'a> = SerializedFileWriter<&'a mut BufWriter<File>>;

/// Rows held in memory until they are written: 0.5 MB a column.
const GROUP_ROWS: usize = 1 << 17;

const NAME: &str = "frames.parquet";

/// The table, without the ending of its file.
pub(crate) const TABLE: &str = "frames";

/// Frames up to some moment of a run, as stored in a checkpoint: the waiting rows and the number of
/// parts on the disk.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FramesSoFar {
    parts: usize,
    waiting: FrameRows,
}

/// Writes frames.
///
/// Rows are collected until there are 131 072 of them and are then written to a file of their own,
/// `frames.parts/000001.parquet` and so on; [`FrameWriter::write`] joins these parts to
/// `frames.parquet`. A run can continue from any checkpoint ([`FrameWriter::so_far`]) that was
/// written since.
pub struct FrameWriter {
    folder: PathBuf,
    channels: Vec<Channel>,
    layout: Layout,
    so_far: FramesSoFar,
    /// Whether `frames.parquet` has them all.
    written: bool,
}

impl FrameWriter {
    /// Starts frames in a folder with these channels; those of an earlier run are removed.
    pub(crate) fn create(folder: &Path, channels: &[Channel]) -> Result<Self, ResultsError> {
        let path = folder.join(NAME);
        if let Err(source) = fs::remove_file(&path)
            && source.kind() != io::ErrorKind::NotFound
        {
            return Err(ResultsError::Write { path, source });
        }
        let so_far = FramesSoFar { parts: 0, waiting: FrameRows::none(channels) };
        Self::resume(folder, channels, so_far)
    }

    /// Resumes frames; parts written since the checkpoint are removed.
    ///
    /// # Errors
    /// Parts that are missing or damaged, and frames of other channels.
    pub(crate) fn resume(
        folder: &Path,
        channels: &[Channel],
        so_far: FramesSoFar,
    ) -> Result<Self, ResultsError> {
        let unfit = |reason: &str| ResultsError::Checkpoint {
            path: folder.join(CHECKPOINT),
            reason: reason.into(),
        };
        if !so_far.waiting.are_of(channels) {
            return Err(unfit("its frames have other columns"));
        }
        if !so_far.waiting.is_sound() {
            return Err(unfit("it is damaged (its frames)"));
        }
        let layout = Layout::of(channels)
            .map_err(|error| ResultsError::format(&folder.join(NAME), error))?;
        let parts = Parts { folder, table: TABLE };
        for number in 1..=so_far.parts {
            parts.open(number)?;
        }
        parts.remove(so_far.parts)?;
        Ok(Self {
            folder: folder.to_owned(),
            channels: channels.to_vec(),
            layout,
            so_far,
            written: false,
        })
    }

    /// Adds a frame of an operation.
    pub fn push(&mut self, operation: &str, frame: &Frame) -> Result<(), ResultsError> {
        self.written = false;
        self.so_far.waiting.push(operation, frame, &self.channels);
        if self.so_far.waiting.len() >= GROUP_ROWS {
            self.write_part()?;
        }
        Ok(())
    }

    /// Returns the data that a checkpoint must store to continue from here.
    pub fn so_far(&self) -> &FramesSoFar {
        &self.so_far
    }

    /// Writes `frames.parquet` with all frames so far. Its bytes depend on the frames alone, not on
    /// where a run was resumed.
    pub fn write(&mut self) -> Result<(), ResultsError> {
        if self.written {
            return Ok(());
        }
        let write = |file: &mut Writer<'_>| {
            self.parts().copy(1..=self.so_far.parts, file)?;
            match self.so_far.waiting.len() {
                0 => Ok(()),
                _ => self.so_far.waiting.write_group(file),
            }
        };
        write_whole(&self.folder.join(NAME), |writer| {
            self.write_file(writer, write).map_err(io_error)
        })?;
        self.written = true;
        Ok(())
    }

    fn parts(&self) -> Parts<'_> {
        Parts { folder: &self.folder, table: TABLE }
    }

    fn write_part(&mut self) -> Result<(), ResultsError> {
        self.parts().write(self.so_far.parts + 1, |writer| {
            self.write_file(writer, |file| self.so_far.waiting.write_group(file))
        })?;
        self.so_far.parts += 1;
        self.so_far.waiting.clear();
        Ok(())
    }

    fn write_file(
        &self,
        writer: &mut BufWriter<File>,
        write: impl FnOnce(&mut Writer<'_>) -> Result<(), ParquetError>,
    ) -> Result<(), ParquetError> {
        let mut file = self.layout.begin(writer)?;
        write(&mut file)?;
        file.close().map(drop)
    }
}
