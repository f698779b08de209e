//! Frames of the whole string on their way to the disk.

use wholestring::{dynamics::Simulation, operation::Operation, outcome::ModelKind};
use wholestring_case::Case;
use wholestring_results::{FrameWriter, ResultsError, ResultsFolder};

/// Frames at even spacing in time.
pub(crate) struct Frames {
    writer: FrameWriter,
    interval_s: f64,
}

impl Frames {
    /// Begins the file, where the case asks for frames and a model can give them.
    pub(crate) fn begin(case: &Case, folder: &ResultsFolder) -> Result<Option<Self>, ResultsError> {
        match case.records.frame_interval_s {
            Some(interval_s) if case.models.contains(&ModelKind::Dynamic) => Ok(Some(Self {
                writer: folder.frames(&case.records.channels)?,
                interval_s,
            })),
            _ => Ok(None),
        }
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

    /// Ends the file.
    pub(crate) fn finish(self) -> Result<(), ResultsError> {
        self.writer.finish()
    }
}
