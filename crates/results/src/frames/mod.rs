//! `frames.parquet`: the whole string against time, written as it comes, in memory that does not
//! grow with the run.

mod rows;

use std::{
    fs::{self, File},
    io::{self, BufWriter},
    path::{Path, PathBuf},
};

use parquet::{
    errors::ParquetError,
    file::{
        metadata::{ParquetMetaData, ParquetMetaDataReader},
        writer::SerializedFileWriter,
    },
};
use serde::{Deserialize, Serialize};
use wholestring::dynamics::{Channel, Frame};

use self::rows::{FrameRows, Layout};
use crate::{
    ResultsError,
    file::write_whole,
    names::CHECKPOINT,
    parquet_file::{self, copy_groups, io_error},
};

/// What a Parquet file of frames is written by.
type Writer<'a> = SerializedFileWriter<&'a mut BufWriter<File>>;

/// Rows that are held until they are written: 0.5 MB a column.
const GROUP_ROWS: usize = 1 << 17;

const NAME: &str = "frames.parquet";

/// The folder of the parts.
const PARTS: &str = "frames.parts";

/// Frames up to some moment of a run, as a checkpoint keeps them: the rows that wait, and how many
/// parts are on the disk.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FramesSoFar {
    parts: usize,
    waiting: FrameRows,
}

/// Writes frames.
///
/// Rows gather until there are 131 072 of them and go to a file of their own,
/// `frames.parts/000001.parquet` and so on; [`FrameWriter::write`] joins these parts to
/// `frames.parquet`. A part is never touched again, so that a run can continue from any checkpoint
/// ([`FrameWriter::so_far`]) that was written since: it drops the parts that are younger, and
/// writes the same ones again. The parts go with the checkpoint
/// ([`ResultsFolder::remove_checkpoint`](crate::ResultsFolder::remove_checkpoint)).
pub struct FrameWriter {
    folder: PathBuf,
    channels: Vec<Channel>,
    layout: Layout,
    so_far: FramesSoFar,
    /// Whether `frames.parquet` holds them all.
    written: bool,
}

impl FrameWriter {
    /// Begins frames in a folder with these channels; what an earlier run left goes.
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
        for number in 1..=so_far.parts {
            Part::open(folder, number)?;
        }
        remove_parts(folder, so_far.parts)?;
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

    /// What a checkpoint must keep, to continue from here.
    pub fn so_far(&self) -> &FramesSoFar {
        &self.so_far
    }

    /// Writes `frames.parquet` with all frames so far. Its bytes depend on the frames alone, not on
    /// where a run was taken up.
    pub fn write(&mut self) -> Result<(), ResultsError> {
        if self.written {
            return Ok(());
        }
        self.write_file(&self.folder.join(NAME), |file| {
            for number in 1..=self.so_far.parts {
                let part = Part::open(&self.folder, number);
                let part = part.map_err(|error| ParquetError::External(error.into()))?;
                copy_groups(&part.file, &part.metadata, usize::MAX, file)?;
            }
            match self.so_far.waiting.len() {
                0 => Ok(()),
                _ => self.so_far.waiting.write_group(file),
            }
        })?;
        self.written = true;
        Ok(())
    }

    fn write_part(&mut self) -> Result<(), ResultsError> {
        let path = part_path(&self.folder, self.so_far.parts + 1);
        let place = self.folder.join(PARTS);
        fs::create_dir_all(&place)
            .map_err(|source| ResultsError::Folder { path: place, source })?;
        self.write_file(&path, |file| self.so_far.waiting.write_group(file))?;
        self.so_far.parts += 1;
        self.so_far.waiting.clear();
        Ok(())
    }

    fn write_file(
        &self,
        path: &Path,
        write: impl FnOnce(&mut Writer<'_>) -> Result<(), ParquetError>,
    ) -> Result<(), ResultsError> {
        let write = |writer: &mut BufWriter<File>| {
            let mut file = self.layout.begin(writer)?;
            write(&mut file)?;
            file.close().map(drop)
        };
        write_whole(path, |writer| write(writer).map_err(io_error))
    }
}

/// `frames.parts/000001.parquet`: in the order of their names wherever they are listed.
fn part_path(folder: &Path, number: usize) -> PathBuf {
    folder.join(PARTS).join(format!("{number:06}.parquet"))
}

/// A part on the disk: a Parquet file with a row group.
struct Part {
    file: File,
    metadata: ParquetMetaData,
}

impl Part {
    fn open(folder: &Path, number: usize) -> Result<Self, ResultsError> {
        let path = part_path(folder, number);
        let file = parquet_file::open(&path)?;
        let metadata =
            parquet_file::guarded(&path, || ParquetMetaDataReader::new().parse_and_finish(&file))?;
        Ok(Self { file, metadata })
    }
}

/// Removes all parts but the first `kept`, and with the last of them their folder.
pub(crate) fn remove_parts(folder: &Path, kept: usize) -> Result<(), ResultsError> {
    let place = folder.join(PARTS);
    let remove = || -> io::Result<()> {
        if kept == 0 {
            return fs::remove_dir_all(&place);
        }
        let kept: Vec<PathBuf> = (1..=kept).map(|number| part_path(folder, number)).collect();
        for entry in fs::read_dir(&place)? {
            let path = entry?.path();
            if !kept.contains(&path) {
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
