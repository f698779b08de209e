//! Frames of the whole string on their way to the disk.

use wholestring::{dynamics::Simulation, operation::Operation, outcome::ModelKind};
use wholestring_case::Case;
use wholestring_results::{FrameWriter, FramesSoFar, ResultsError, ResultsFolder};

/// Frames at even spacing in time.
pub(crate) struct Frames {
    writer: FrameWriter,
    interval_s: f64,
}

impl Frames {
    /// Begins them, or continues from what a checkpoint kept, where the case requires frames and a
    /// model can give them.
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

    /// What a checkpoint must keep.
    pub(crate) fn so_far(&self) -> &FramesSoFar {
        self.writer.so_far()
    }

    /// Samples from one frame to the next.
    pub(crate) fn samples(&self, sample_interval_s: f64) -> u64 {
        (self.interval_s / sample_interval_s).round().max(1.0) as u64
    }

    /// Takes the string as it is.
    pub(crate) fn take(
        &mut self,
        operation: &Operation,
        simulation: &Simulation,
    ) -> Result<(), ResultsError> {
        self.writer.push(operation.kind.name(), &simulation.frame())
    }

    /// Writes the file with all that were taken.
    pub(crate) fn write(&mut self) -> Result<(), ResultsError> {
        self.writer.write()
    }
}
