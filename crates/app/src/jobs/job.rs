//! What is known of a job, as it is kept.

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::work::JobRequest;

/// A job.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct Job {
    /// What requests call it.
    pub(crate) id: String,
    /// What was asked for.
    pub(crate) request: JobRequest,
    /// The command: `run`, `plan`, ...
    pub(crate) command: String,
    /// What the case is called, or the study.
    pub(crate) title: String,
    /// The place of its file in the folder.
    pub(crate) path: String,
    /// How far it is.
    pub(crate) state: State,
    /// When it was asked for, milliseconds since 1970.
    pub(crate) created_ms: u64,
    /// When it was begun, the last time where it was resumed.
    pub(crate) started_ms: Option<u64>,
    /// When it ended.
    pub(crate) ended_ms: Option<u64>,
    /// The place in the folder where its results are.
    pub(crate) folder: Option<String>,
    /// What there is to say about its end.
    pub(crate) message: Option<String>,
    /// Why the folder of the results, or what lies there, was refused.
    pub(crate) refusal: Option<Refusal>,
}

/// How far a job is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum State {
    /// Others are before it.
    Waiting,
    /// It goes on.
    Running,
    /// It has come to its end.
    Finished,
    /// The user stopped it; what it had computed is kept.
    Stopped,
    /// The program ended before it did.
    Interrupted,
    /// It has no answer, or could not be written.
    Failed,
    /// It was not begun: the input or the folder is against it.
    Refused,
}

impl State {
    /// Whether it will go on by itself.
    pub(crate) fn is_open(self) -> bool {
        matches!(self, Self::Waiting | Self::Running)
    }
}

/// Why work was refused where it would have gone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Refusal {
    /// The same work was begun there: it can be continued, or replaced.
    Unfinished,
    /// Other results lie there: they can be replaced.
    Occupied,
    /// Another program writes there.
    Busy,
    /// What lies there cannot be continued: it can be replaced.
    NotResumable,
}
