//! The saved record of a job, and the outcome of its work with its message.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_runner::{BatchOutcome, Error, FolderRefused, job::JobOutcome};

use super::prepared::JobRequest;

/// A job.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct Job {
    /// Identifier in requests.
    pub(crate) id: String,
    /// The request.
    pub(crate) request: JobRequest,
    /// The command: `run`, `plan`, ...
    pub(crate) command: String,
    /// Name of the case or the study.
    pub(crate) title: String,
    /// Path of its file in the folder.
    pub(crate) path: String,
    /// Its state.
    pub(crate) state: State,
    /// Time of the request, milliseconds since 1970.
    pub(crate) created_ms: u64,
    /// Time of the start, or of the latest resumption.
    pub(crate) started_ms: Option<u64>,
    /// Time of the end.
    pub(crate) ended_ms: Option<u64>,
    /// Path of its results in the folder.
    pub(crate) folder: Option<String>,
    /// Message about its end.
    pub(crate) message: Option<String>,
    /// Reason why the results folder was refused.
    pub(crate) refusal: Option<Refusal>,
}

/// State of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum State {
    /// Waits for other jobs.
    Waiting,
    /// Is running.
    Running,
    /// Has finished.
    Finished,
    /// The user stopped it; its computed results are kept.
    Stopped,
    /// The program ended before it did.
    Interrupted,
    /// It has no result, or could not be written.
    Failed,
    /// It did not start, because the input or the folder was refused.
    Refused,
}

impl State {
    /// Whether it is waiting or running.
    pub(crate) fn is_open(self) -> bool {
        matches!(self, Self::Waiting | Self::Running)
    }
}

/// Reason why the results folder of some work was refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Refusal {
    /// The same work is unfinished there: it can be continued or replaced.
    Unfinished,
    /// The folder has other results, which can be replaced.
    Occupied,
    /// Another program writes there.
    Busy,
    /// Its contents cannot be continued, but replaced.
    NotResumable,
}

// Outcome of work, with its message.

/// Outcome of work.
#[derive(Debug)]
pub(super) struct Ended {
    /// The results folder, if there are results.
    pub(super) folder: Option<PathBuf>,
    pub(super) state: State,
    pub(super) message: Option<String>,
    pub(super) refusal: Option<Refusal>,
}

impl Ended {
    /// The work ended with this outcome.
    pub(super) fn of(outcome: JobOutcome) -> Self {
        if let Some((batch, items)) = outcome.batch() {
            return Self::batch(batch, items);
        }
        match outcome.into_parts() {
            (folder, None) => Self::finished(folder, None),
            (folder, Some(Error::Interrupted)) => Self::stopped(folder),
            (folder, Some(error)) => Self::failed(folder, error.to_string()),
        }
    }

    /// The work finished.
    fn finished(folder: PathBuf, message: Option<String>) -> Self {
        Self { folder: Some(folder), state: State::Finished, message, refusal: None }
    }

    /// The work was stopped; `is_resumable` is whether it can be continued.
    fn stopped(folder: PathBuf) -> Self {
        let message = Some("stopped: partial results are kept".to_owned());
        Self { folder: Some(folder), state: State::Stopped, message, refusal: None }
    }

    /// The work has no complete result.
    fn failed(folder: PathBuf, message: String) -> Self {
        Self { folder: Some(folder), state: State::Failed, message: Some(message), refusal: None }
    }

    /// Many cases or points, called `items`.
    fn batch(outcome: &BatchOutcome, items: &str) -> Self {
        let folder = outcome.folder.clone();
        let (all, finished) = (outcome.all, outcome.finished);
        let items = if all == 1 { items.trim_end_matches('s') } else { items };
        let failed = outcome.failed.iter();
        let failed: Vec<String> =
            failed.map(|failed| format!("{}: {}", failed.name, failed.reason)).collect();
        let count = format!("{finished} of {all} {items} finished");
        if outcome.is_interrupted() {
            let lines = [vec![format!("stopped: {count}; they are kept")], failed].concat();
            return Self { message: Some(lines.join("\n")), ..Self::stopped(folder) };
        }
        if !failed.is_empty() {
            let head = format!("{} of {all} {items} failed", failed.len());
            return Self::failed(folder, [vec![head], failed].concat().join("\n"));
        }
        let wrong = outcome.with_errors.iter();
        let wrong: Vec<String> = wrong
            .map(|row| format!("errors were found in {}: {}", row.name, row.operations.join(", ")))
            .collect();
        Self::finished(folder, Some([vec![count], wrong].concat().join("\n")))
    }

    /// The work did not start or did not finish. Paths are relative to the folder.
    pub(super) fn of_error(error: &Error, root: &Path) -> Self {
        let (state, refusal) = match error {
            Error::Unsound(_) | Error::BadInput(_) => (State::Refused, None),
            Error::NotResumable { .. } => (State::Refused, Some(Refusal::NotResumable)),
            Error::Folder(refused) => (State::Refused, refusal(refused)),
            Error::Results(error) if error.is_of_reading() => (State::Refused, None),
            Error::Results(_) | Error::Failed(_) => (State::Failed, None),
            Error::Interrupted => (State::Stopped, None),
        };
        let message = match error {
            Error::Interrupted => "stopped: nothing was computed yet".to_owned(),
            error => error.to_string(),
        };
        let message = Some(message.replace(&format!("{}/", root.display()), ""));
        Self { folder: None, state, message, refusal }
    }
}

fn refusal(refused: &FolderRefused) -> Option<Refusal> {
    match refused {
        FolderRefused::Occupied { .. } | FolderRefused::Foreign { .. } => Some(Refusal::Occupied),
        FolderRefused::Unfinished { .. } => Some(Refusal::Unfinished),
        FolderRefused::Busy { .. } | FolderRefused::ShareBusy { .. } => Some(Refusal::Busy),
        FolderRefused::AllOccupied { .. } => None,
    }
}
