//! The folder that a run writes to.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use wholestring::dynamics::Channel;

use crate::{FrameWriter, FramesSoFar, ResultsError, Summary, Table};

/// The folder that a run writes to.
#[derive(Debug, Clone)]
pub struct ResultsFolder {
    path: PathBuf,
}

impl ResultsFolder {
    /// Makes the folder and its parents where they do not exist, and makes sure that files can be
    /// written there, so that a long run does not end on a folder it may not write to.
    pub fn create(path: impl Into<PathBuf>) -> Result<Self, ResultsError> {
        let path = path.into();
        fs::create_dir_all(&path)
            .map_err(|source| ResultsError::Folder { path: path.clone(), source })?;
        let probe = path.join(".write-test");
        fs::write(&probe, "")
            .map_err(|source| ResultsError::Write { path: path.clone(), source })?;
        // It was just made, so failing to remove it does no harm.
        let _ = fs::remove_file(&probe);
        Ok(Self { path })
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes `summary.json`.
    pub fn write_summary(&self, summary: &Summary) -> Result<(), ResultsError> {
        summary.write(&self.path.join("summary.json"))
    }

    /// Writes `summary.json` without blanks, not waiting for the disk: [`Summary::write_compact`].
    pub fn write_compact_summary(&self, summary: &Summary) -> Result<(), ResultsError> {
        summary.write_compact(&self.path.join("summary.json"))
    }

    /// Writes `<name>.parquet`, and `<name>.csv` where `csv` requires it. Where it does not, the
    /// CSV that an earlier run left is removed, so that the folder never mixes two runs.
    pub fn write_table(&self, name: &str, table: &Table, csv: bool) -> Result<(), ResultsError> {
        table.write_parquet(&self.path.join(format!("{name}.parquet")))?;
        let csv_name = format!("{name}.csv");
        if csv {
            return table.write_csv(&self.path.join(csv_name));
        }
        self.remove(&csv_name)
    }

    /// Removes a file that an earlier run left and this one does not write.
    pub fn remove(&self, name: &str) -> Result<(), ResultsError> {
        let path = self.path.join(name);
        match fs::remove_file(&path) {
            Err(source) if source.kind() != io::ErrorKind::NotFound => {
                Err(ResultsError::Write { path, source })
            }
            _ => Ok(()),
        }
    }

    /// Starts `frames.parquet` with these channels; a file of an earlier run is removed.
    pub fn frames(&self, channels: &[Channel]) -> Result<FrameWriter, ResultsError> {
        FrameWriter::create(&self.path, channels)
    }

    /// Resumes the frames of the same channels from a checkpoint; frames written since are removed.
    ///
    /// # Errors
    /// Frames of other channels, and parts on the disk that are missing or damaged.
    pub fn resume_frames(
        &self,
        channels: &[Channel],
        so_far: FramesSoFar,
    ) -> Result<FrameWriter, ResultsError> {
        FrameWriter::resume(&self.path, channels, so_far)
    }

    /// Writes a file, such as a picture.
    pub fn write_file(&self, name: &str, bytes: &[u8]) -> Result<(), ResultsError> {
        crate::file::write_whole(&self.path.join(name), |writer| {
            std::io::Write::write_all(writer, bytes)
        })
    }
}
