//! A run that was written to a checkpoint.
//!
//! A checkpoint contains the whole state of a run: its solved operations and the current state of
//! the operation under way. The results in the folder are not read, so that files that were being
//! written when the run was killed do not matter. Only frames are too many to store: a checkpoint
//! contains the number of their parts on the disk, and the frames not yet written.

use std::time::Duration;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::{
    dynamics::{Checkpoint, TunedHookLoad},
    operation::Operation,
};
use wholestring_case::Case;
use wholestring_results::ResultsFolder;

use super::difference::difference;
use crate::record::{Record, Solved};

/// An operation that the dynamics were solving.
#[derive(Serialize, Deserialize)]
pub(crate) struct UnderWay<'a> {
    /// Name of the operation.
    operation: String,
    /// Wall-clock time so far, s.
    pub(crate) wall_time_s: f64,
    /// Lift found for it, if it hangs on one.
    pub(crate) lift: Option<TunedHookLoad>,
    pub(crate) simulation: Checkpoint<'a>,
}

impl<'a> UnderWay<'a> {
    pub(crate) fn new(
        operation: &Operation,
        took: Duration,
        lift: Option<TunedHookLoad>,
        simulation: Checkpoint<'a>,
    ) -> Self {
        Self {
            operation: operation.kind.name().to_owned(),
            wall_time_s: took.as_secs_f64(),
            lift,
            simulation,
        }
    }

    pub(crate) fn is(&self, operation: &Operation) -> bool {
        self.operation == operation.kind.name()
    }
}

/// A run that was written to a checkpoint.
#[derive(Serialize, Deserialize)]
pub(crate) struct RunCheckpoint<'a> {
    /// All settings that the case's answers depend on, as JSON.
    identity: String,
    /// The case's settings, as JSON, for messages.
    settings: String,
    pub(crate) solved: Solved<'a>,
    pub(crate) under_way: Option<UnderWay<'a>>,
}

impl<'a> RunCheckpoint<'a> {
    /// Creates the checkpoint of a run.
    pub(crate) fn new(record: &'a Record, under_way: Option<UnderWay<'a>>) -> Self {
        Self {
            identity: record.identity.to_string(),
            settings: record.summary.settings.to_string(),
            solved: record.solved_so_far(),
            under_way,
        }
    }

    /// Reads the checkpoint in the folder, if there is one.
    ///
    /// # Errors
    /// The reason why the case cannot continue from it.
    pub(crate) fn read(folder: &ResultsFolder, case: &Case) -> Result<Option<Self>, String> {
        let stored: Option<Self> = folder.read_checkpoint().map_err(|e| e.to_string())?;
        let Some(stored) = stored else {
            return Ok(None);
        };
        let read = |text: &str| serde_json::from_str(text).map_err(|e| e.to_string());
        let (identity, settings): (Value, Value) =
            (read(&stored.identity)?, read(&stored.settings)?);
        let here = case.identity();
        if let Some(under_way) = &stored.under_way
            && Duration::try_from_secs_f64(under_way.wall_time_s).is_err()
        {
            let place = folder.path().display();
            return Err(format!("the checkpoint in {place} is damaged: its wall-clock time"));
        }
        if identity == here {
            return Ok(Some(stored));
        }
        // Named by the settings if they differ.
        let difference = difference(&settings, &case.settings);
        let difference = difference.or_else(|| super::difference::difference(&identity, &here));
        Err(format!(
            "the checkpoint in {} is of another case: {}",
            folder.path().display(),
            difference.unwrap_or_default()
        ))
    }
}
