//! The saved record of a job.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::request::JobRequest;

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
