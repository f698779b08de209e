//! The request of a job: a command of the program on a saved case.

use std::{collections::BTreeMap, path::PathBuf};

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_runner::{
    Existing,
    job::{Job, Work},
};

use super::error::JobError;

/// A request to run a command of the program on a saved case. The files that the command reads are
/// identified as in the lists of the folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct JobRequest {
    /// The id of the case; none for a study, which names its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) case: Option<String>,
    /// The command.
    pub(crate) work: Work,
    /// Values by key, as in `--set KEY=VALUE`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(crate) set: BTreeMap<String, String>,
    /// Treatment of existing files in the results folder.
    #[serde(default)]
    pub(crate) if_there: Existing,
}

impl JobRequest {
    /// The job of the runner; its destination is chosen when it starts.
    ///
    /// # Errors
    /// A change without a key or a value.
    pub(super) fn job(&self) -> Result<Job, JobError> {
        let set = self.set.iter().map(|(key, value)| format!("{key}={value}").parse());
        let set = set.collect::<Result<_, wholestring_case::OverrideError>>();
        let set = set.map_err(|error| JobError::BadInput(error.to_string()))?;
        Ok(Job { set, ..Job::new(self.case.as_ref().map(PathBuf::from), self.work.clone()) })
    }
}
