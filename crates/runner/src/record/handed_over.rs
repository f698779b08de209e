//! Results that a long run moves to the disk: parts of its time histories, and frames of the whole
//! string.

use std::{
    path::{Path, PathBuf},
    sync::Mutex,
};

use wholestring::{
    dynamics::Simulation,
    operation::Operation,
    outcome::{EarlierRows, ModelKind},
};
use wholestring_case::Case;
use wholestring_results::{FrameWriter, FramesSoFar, ResultsError, ResultsFolder, Table};

use crate::parallel::lock;

/// Rows of a part: 16 384 are 164 s of a run that is sampled every 10 ms, and 10 MB of memory.
pub(crate) const PART_ROWS: usize = 1 << 14;

/// The rows that one operation has moved to the disk.
#[derive(Debug)]
pub(crate) struct HandedOver {
    parts: Vec<PathBuf>,
    fault: Mutex<Option<ResultsError>>,
}

impl HandedOver {
    /// Creates them from these parts, each of [`PART_ROWS`] rows.
    pub(super) fn new(parts: Vec<PathBuf>) -> Self {
        Self { parts, fault: Mutex::new(None) }
    }

    /// No rows.
    pub(crate) fn none() -> Self {
        Self::new(Vec::new())
    }

    /// The first error in reading rows, if there was one.
    pub(crate) fn fault(&self) -> Option<String> {
        lock(&self.fault).as_ref().map(ToString::to_string)
    }

    /// Columns of a part; empty if it cannot be read.
    fn read(&self, part: &Path, names: &[&'static str]) -> Vec<Vec<f64>> {
        let mut columns = vec![Vec::with_capacity(PART_ROWS); names.len()];
        let read = Table::read_parquet_pieces(part, names, |piece| {
            for (column, name) in columns.iter_mut().zip(names) {
                let numbers = piece.numbers(name).unwrap_or_default();
                column.extend(numbers.iter().map(|number| number.unwrap_or(f64::NAN)));
            }
        });
        let whole = columns.iter().all(|column| column.len() == PART_ROWS);
        let read = read.and_then(|()| match whole {
            true => Ok(()),
            false => {
                let reason = "it lacks rows that were written to it".to_owned();
                Err(ResultsError::Format { path: part.to_owned(), reason })
            }
        });
        if let Err(error) = read {
            lock(&self.fault).get_or_insert(error);
            columns.iter_mut().for_each(|column| *column = vec![f64::NAN; PART_ROWS]);
        }
        columns
    }
}

impl EarlierRows for HandedOver {
    fn rows(&self) -> usize {
        self.parts.len() * PART_ROWS
    }

    fn each(&self, columns: &[&'static str], from: usize, take: &mut dyn FnMut(&[&[f64]])) {
        let mut skipped = from % PART_ROWS;
        for part in self.parts.iter().skip(from / PART_ROWS) {
            let read = self.read(part, columns);
            let slices: Vec<&[f64]> = read.iter().map(|column| &column[skipped..]).collect();
            take(&slices);
            skipped = 0;
        }
    }
}

// Writing of frames of the whole string to the disk.

/// Frames at equal intervals of time.
pub(crate) struct Frames {
    writer: FrameWriter,
    interval_s: f64,
}

impl Frames {
    /// Starts the frames, or continues from a checkpoint, if the case requires frames and a model
    /// can provide them.
    pub(crate) fn begin(
        case: &Case,
        folder: &ResultsFolder,
        so_far: Option<FramesSoFar>,
    ) -> Result<Option<Self>, ResultsError> {
        let Some(interval_s) = case.records.frame_interval_s else {
            return Ok(None);
        };
        if !ModelKind::any_in_time(&case.models) {
            return Ok(None);
        }
        let channels = &case.records.channels;
        let writer = match so_far {
            None => folder.frames(channels)?,
            Some(so_far) => folder.resume_frames(channels, so_far)?,
        };
        Ok(Some(Self { writer, interval_s }))
    }

    /// State for a checkpoint.
    pub(crate) fn so_far(&self) -> &FramesSoFar {
        self.writer.so_far()
    }

    /// Number of samples between two frames.
    pub(crate) fn samples(&self, sample_interval_s: f64) -> u64 {
        (self.interval_s / sample_interval_s).round().max(1.0) as u64
    }

    /// Adds the current state of the string.
    pub(crate) fn take(
        &mut self,
        operation: &Operation,
        simulation: &Simulation,
    ) -> Result<(), ResultsError> {
        self.writer.push(operation.kind.name(), &simulation.frame())
    }

    /// Writes the file with all frames.
    pub(crate) fn write(&mut self) -> Result<(), ResultsError> {
        self.writer.write()
    }
}
