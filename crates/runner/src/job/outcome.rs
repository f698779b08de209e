//! The outcome of a job, whichever command it is.

use std::path::{Path, PathBuf};

use wholestring_results::{Check, Severity};

use crate::{
    batch::BatchOutcome, bha, bit_test, calibrate, checks, error::Error, modes, plan, reach, run,
};

/// Outcome of a job: that of its command.
#[derive(Debug)]
#[must_use = "the work may not be complete"]
pub enum JobOutcome {
    /// Of `run`.
    Run(run::Outcome),
    /// Of `plan`.
    Plan(Box<plan::Outcome>),
    /// Of `reach`.
    Reach(reach::Outcome),
    /// Of `bha`.
    Bha(bha::Outcome),
    /// Of `modes`.
    Modes(modes::Outcome),
    /// Of `calibrate`.
    Calibrate(calibrate::Outcome),
    /// Of `sweep`.
    Sweep(BatchOutcome),
    /// Of `study`.
    Study(BatchOutcome),
    /// Of `bit-test`.
    BitTest(bit_test::Outcome),
}

impl JobOutcome {
    /// Folder of the results.
    pub fn folder(&self) -> &Path {
        match self {
            Self::Run(outcome) => &outcome.folder,
            Self::Plan(outcome) => &outcome.batch.folder,
            Self::Reach(outcome) => &outcome.folder,
            Self::Bha(outcome) => &outcome.folder,
            Self::Modes(outcome) => &outcome.folder,
            Self::Calibrate(outcome) => &outcome.folder,
            Self::Sweep(batch) | Self::Study(batch) => &batch.folder,
            Self::BitTest(outcome) => &outcome.batch.folder,
        }
    }

    /// Counts of the parts of the work, and the word for them; none for work of one part.
    pub fn batch(&self) -> Option<(&BatchOutcome, &'static str)> {
        match self {
            Self::Plan(outcome) => Some((&outcome.batch, "tasks")),
            Self::Reach(outcome) => outcome.samples.as_ref().map(|samples| (samples, "samples")),
            Self::Sweep(batch) | Self::Study(batch) => Some((batch, "cases")),
            Self::BitTest(outcome) => Some((&outcome.batch, "points")),
            Self::Run(_) | Self::Bha(_) | Self::Modes(_) | Self::Calibrate(_) => None,
        }
    }

    /// Checks whose severity is error, as a line of words each: the operation where there are
    /// several, and the label of the check; for a run, each operation that has one.
    pub fn errors(&self) -> Vec<String> {
        fn labels<'a>(checks: impl Iterator<Item = (&'a str, &'a Check)>) -> Vec<String> {
            let errors = checks.filter(|(_, check)| check.severity == Severity::Error);
            let label = |check: &Check| check.kind.label().to_lowercase();
            let mut lines: Vec<String> = errors
                .map(|(name, check)| match name {
                    "" => label(check),
                    name => format!("{name}: {}", label(check)),
                })
                .collect();
            lines.dedup();
            lines
        }
        let unnamed = |checks: &[Check]| labels(checks.iter().map(|check| ("", check)));
        match self {
            Self::Run(outcome) => {
                let operations = outcome.summary.operations.iter();
                operations.filter(|solved| checks::has_error(solved)).map(checks::name).collect()
            }
            Self::Plan(outcome) => {
                let rows = outcome.summary.checks.iter();
                labels(rows.map(|row| (row.operation.words(), &row.check)))
            }
            Self::Reach(outcome) => {
                let rows = outcome.summary.checks.iter();
                labels(rows.map(|row| (row.operation.words(), &row.check)))
            }
            Self::Bha(outcome) => unnamed(&outcome.summary.checks),
            Self::Modes(outcome) => unnamed(&outcome.summary.checks),
            Self::Calibrate(outcome) => {
                labels(outcome.summary.checks.iter().map(|row| ("", &row.check)))
            }
            Self::BitTest(outcome) => unnamed(&outcome.summary.checks),
            Self::Sweep(batch) | Self::Study(batch) => {
                let cases = batch.with_errors.iter();
                cases.map(|case| format!("{}: {}", case.name, case.operations.join(", "))).collect()
            }
        }
    }

    /// The folder, and the reason why the work is not complete, if it is not.
    pub fn into_parts(self) -> (PathBuf, Option<Error>) {
        fn of_batch(batch: BatchOutcome) -> (PathBuf, Option<Error>) {
            (batch.folder.clone(), batch.finished().err())
        }
        let at_once =
            |folder, interrupted: bool| (folder, interrupted.then_some(Error::Interrupted));
        match self {
            Self::Run(outcome) => (outcome.folder, outcome.stopped.map(Error::from)),
            Self::Plan(outcome) => of_batch(outcome.batch),
            Self::Reach(outcome) => {
                let samples = outcome.samples.and_then(|batch| batch.finished().err());
                let (folder, interrupted) = at_once(outcome.folder, outcome.interrupted);
                (folder, samples.or(interrupted))
            }
            Self::Bha(outcome) => at_once(outcome.folder, outcome.interrupted),
            Self::Modes(outcome) => at_once(outcome.folder, outcome.interrupted),
            Self::Calibrate(outcome) => at_once(outcome.folder, outcome.interrupted),
            Self::Sweep(batch) | Self::Study(batch) => of_batch(batch),
            Self::BitTest(outcome) => of_batch(outcome.batch),
        }
    }
}
