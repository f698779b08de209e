//! Writing of frames of the whole string to the disk.

use wholestring::{dynamics::Simulation, operation::Operation, outcome::ModelKind};
use wholestring_case::Case;
use wholestring_results::{FrameWriter, FramesSoFar, ResultsError, ResultsFolder};

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
