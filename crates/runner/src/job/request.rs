//! A job as it is written or sent.

use std::{num::NonZeroUsize, path::PathBuf};

use serde::{Deserialize, Serialize};
use wholestring_case::Override;
use wholestring_units::UnitSet;

use super::{options, work::Work};
use crate::output::Output;

/// A command with its case and options.
///
/// ```
/// use wholestring_runner::{CancellationToken, Silent, job::{Job, OnDisk}};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let place = tempfile::tempdir()?;
/// let mut job: Job = serde_json::from_str(
///     r#"{
///         "case": "../../cases/slant.toml",
///         "work": { "kind": "reach", "to": "2 km", "operations": ["drill"] },
///         "set": { "friction": "0.3" }
///     }"#,
/// )?;
/// # job.output.folder = Some(place.path().join("reach"));
/// let outcome = job.run(&OnDisk, &Silent, &CancellationToken::new())?;
/// assert!(outcome.folder().join("reach.parquet").is_file());
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The case file; none for a study, which names its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<PathBuf>,
    /// The command.
    pub work: Work,
    /// Changes of the case, or of all cases, as by `--set`; an object of texts by key.
    #[serde(default, with = "options::changes", skip_serializing_if = "Vec::is_empty")]
    pub set: Vec<Override>,
    /// Destination of the results.
    #[serde(default)]
    pub output: Output,
    /// Units of checks, pages, pictures and workbooks: `si`, `metric` or `field`; those of the case
    /// by default. A sweep and a study use those of their cases.
    #[serde(default, with = "options::unit_set", skip_serializing_if = "Option::is_none")]
    pub units: Option<UnitSet>,
    /// Number of parallel jobs; one per core by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub jobs: Option<NonZeroUsize>,
    /// Wall-clock time between checkpoints, such as `5 min`; that of the case by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub checkpoint: Option<String>,
}

impl Job {
    /// A job with default settings.
    pub fn new(case: Option<PathBuf>, work: Work) -> Self {
        let (set, output) = (Vec::new(), Output::default());
        Self { case, work, set, output, units: None, jobs: None, checkpoint: None }
    }
}
