//! Files in the folder of a point, before and after it is finished.

use std::{borrow::Cow, path::Path};

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::rock::{DrillingSpec, Trial, TrialOutcome};
use wholestring_results::{BIT_TEST_VERSION, BitTestOutcome, ResultsError, ResultsFolder};

use super::points::Point;
use crate::checkpoint::difference;

/// Name of the file of a finished point.
const FILE: &str = "point.json";

/// A trial as stored in its checkpoint.
#[derive(Serialize, Deserialize)]
pub(super) struct PointCheckpoint<'a> {
    /// The point's settings, as JSON.
    settings: String,
    pub(super) trial: Cow<'a, Trial>,
}

impl<'a> PointCheckpoint<'a> {
    pub(super) fn new(point: &Point, trial: &'a Trial) -> Self {
        Self { settings: point.settings.to_string(), trial: Cow::Borrowed(trial) }
    }
}

impl PointCheckpoint<'static> {
    /// Reads the checkpoint in the folder of the point, if there is one.
    ///
    /// # Errors
    /// The reason why the point cannot continue from it.
    pub(super) fn read(
        folder: &ResultsFolder,
        point: &Point,
        drilling: &DrillingSpec,
    ) -> Result<Option<Self>, String> {
        let stored: Option<Self> = folder.read_checkpoint().map_err(|e| e.to_string())?;
        let Some(stored) = stored else {
            return Ok(None);
        };
        let settings: Value = serde_json::from_str(&stored.settings).map_err(|e| e.to_string())?;
        let place = folder.path().display();
        if let Some(difference) = difference(&settings, &point.settings) {
            return Err(format!("the checkpoint in {place} is of another test: {difference}"));
        }
        let valid = stored.trial.check(&point.spec, drilling);
        valid.map_err(|error| format!("the checkpoint in {place} cannot be continued: {error}"))?;
        Ok(Some(stored))
    }
}

/// Reads the outcome of a finished trial from the folder of the point; `None` if it is not finished
/// or belongs to another test.
pub(super) fn finished(folder: &Path, point: &Point) -> Option<TrialOutcome> {
    let there = BitTestOutcome::read(&folder.join(FILE)).ok()?;
    difference(&there.settings, &point.settings).is_none().then_some(there.outcome)
}

/// Marks the point as finished.
pub(super) fn finish(
    folder: &ResultsFolder,
    point: &Point,
    outcome: TrialOutcome,
) -> Result<(), ResultsError> {
    let done = BitTestOutcome {
        schema_version: BIT_TEST_VERSION,
        settings: point.settings.clone(),
        outcome,
    };
    done.write(&folder.path().join(FILE))
}

/// Restarts the point: removes the files that an earlier test left of it.
pub(super) fn begin(folder: &ResultsFolder) -> Result<(), ResultsError> {
    folder.remove(FILE)?;
    folder.remove_checkpoint()
}
