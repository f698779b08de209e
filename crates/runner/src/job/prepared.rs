//! A job whose inputs are read and whose options are checked.

use std::{fmt, path::Path, sync::Arc};

use wholestring_case::{Case, Report};
use wholestring_units::UnitSet;

use super::{
    commands::{self, Execute, Ready, Settings, SweepInput},
    files::JobFiles,
    input::Reader,
    options,
    outcome::JobOutcome,
    request::Job,
    work::Work,
};
use crate::{
    cancellation::CancellationToken, error::Error, observer::Observer, output::Output,
    sweep::PreparedSweep,
};

/// A job whose inputs are read and whose options are checked.
pub struct PreparedJob {
    title: String,
    case: Option<Arc<Case>>,
    units: Option<UnitSet>,
    warnings: Vec<Report>,
    execute: Execute,
}

impl fmt::Debug for PreparedJob {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("PreparedJob").field("title", &self.title).finish_non_exhaustive()
    }
}

impl Job {
    /// Reads the inputs of the job and checks its options; later changes of the files have no
    /// effect.
    ///
    /// # Errors
    /// A missing or invalid file, and an invalid option.
    pub fn prepare(&self, files: &dyn JobFiles) -> Result<PreparedJob, Error> {
        PreparedJob::read(self, files)
    }

    /// Prepares and executes the job; the observer receives the warnings of its input first.
    ///
    /// # Errors
    /// As of [`Job::prepare`] and [`PreparedJob::run`].
    pub fn run(
        &self,
        files: &dyn JobFiles,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<JobOutcome, Error> {
        self.prepare(files)?.execute(self.output.clone(), observer, cancellation)
    }

    /// Checks every case of a sweep and claims its folder; the caller solves or distributes the
    /// cases.
    ///
    /// # Errors
    /// Work that is no sweep, an invalid option or case, and a folder that cannot take the results.
    pub fn begin_sweep(
        &self,
        files: &dyn JobFiles,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<PreparedSweep, Error> {
        let Work::Sweep(options) = &self.work else {
            return Err(Error::BadInput(format!("{} is no sweep", self.work.command())));
        };
        let settings = self.settings()?;
        let reader = Reader { files, set: &self.set, warnings: Vec::new() };
        let sweep = SweepInput::read(&reader, self.named_case()?, options, settings)?;
        PreparedSweep::begin(&sweep.request(self.output.clone()), observer, cancellation)
    }

    fn settings(&self) -> Result<Settings, Error> {
        let Self { work, units, jobs, checkpoint, .. } = self;
        if checkpoint.is_some() && !work.has_checkpoints() {
            return Err(options::refused("checkpoint", format!("{} writes none", work.command())));
        }
        if units.is_some() && matches!(work, Work::Sweep(_) | Work::Study(_)) {
            let reason = format!("a {} uses the units of its cases", work.command());
            return Err(options::refused("units", reason));
        }
        let checkpoint_every = options::checkpoint_interval(checkpoint.as_ref())?;
        Ok(Settings { units: *units, jobs: *jobs, checkpoint_every })
    }

    fn named_case(&self) -> Result<&Path, Error> {
        self.case.as_deref().ok_or_else(|| Error::BadInput("no case is named".to_owned()))
    }
}

impl PreparedJob {
    fn read(job: &Job, files: &dyn JobFiles) -> Result<Self, Error> {
        let settings = job.settings()?;
        let mut reader = Reader { files, set: &job.set, warnings: Vec::new() };
        let Ready { title, case, execute } = match &job.work {
            Work::Study(options) => commands::study(&mut reader, options, settings)?,
            work => of_case(&mut reader, work, job.named_case()?, settings)?,
        };
        Ok(Self { title, case, units: job.units, warnings: reader.warnings, execute })
    }

    /// Name of the case or the study.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Warnings of the inputs.
    pub fn warnings(&self) -> &[Report] {
        &self.warnings
    }

    /// The case; of a calibration the first one, and none for a sweep and a study.
    pub fn case(&self) -> Option<&Case> {
        self.case.as_deref()
    }

    /// Units of checks, pages and pictures.
    pub fn units(&self) -> UnitSet {
        self.units.or_else(|| Some(self.case()?.units)).unwrap_or_default()
    }

    /// Reports the warnings of the inputs, and executes the job.
    ///
    /// # Errors
    /// As of [`Self::run`].
    pub fn execute(
        &self,
        output: Output,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<JobOutcome, Error> {
        self.warnings.iter().for_each(|report| observer.diagnostics(report));
        // The reading of a casing programme changes every result.
        let notes = self.case().map_or(&[][..], |case| &case.hole_notes);
        notes.iter().for_each(|note| observer.note(&format!("hole: {note}")));
        self.run(output, observer, cancellation)
    }

    /// Executes the job.
    ///
    /// # Errors
    /// A folder that cannot take the results, work without a solution, or a cancellation before
    /// there are results. Later stops are in the outcome.
    pub fn run(
        &self,
        output: Output,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<JobOutcome, Error> {
        (self.execute)(output, observer, cancellation)
    }
}

/// The command with its case.
fn of_case(
    reader: &mut Reader<'_>,
    work: &Work,
    case: &Path,
    settings: Settings,
) -> Result<Ready, Error> {
    match work {
        Work::Run { models, csv } => commands::run(reader, case, models, *csv, settings),
        Work::Plan { overlay, png } => {
            commands::plan(reader, case, overlay.as_deref(), *png, settings)
        }
        Work::Reach(options) => commands::reach(reader, case, options, settings),
        Work::Bha(options) => commands::bha(reader, case, options, settings),
        Work::Modes { operation, png } => commands::modes(reader, case, *operation, *png, settings),
        Work::Calibrate(options) => commands::calibrate(reader, case, options, settings),
        Work::Sweep(options) => commands::sweep(reader, case, options, settings),
        Work::Study(options) => commands::study(reader, options, settings),
        Work::BitTest { shard, csv } => {
            commands::bit_test(reader, case, shard.as_ref(), *csv, settings)
        }
    }
}
