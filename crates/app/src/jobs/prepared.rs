//! The request of a job, and its inputs, read at the time of its request, so that later changes of
//! the files do not affect it.

use std::{
    cell::RefCell,
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_case::{Report, Template};
use wholestring_runner::{
    Error, Existing,
    job::{CaseInput, DataInput, Job, JobFiles, PreparedJob, Work},
    study::{self, Study},
};

use crate::workspace::{OtherFile, Workspace, WorkspaceError};

/// The inputs of a job.
#[derive(Debug)]
pub(super) struct Prepared {
    /// Path of the case or the study in the folder.
    pub(super) path: String,
    pub(super) job: PreparedJob,
}

impl Prepared {
    /// Reads and checks the inputs of a job.
    ///
    /// # Errors
    /// A missing or invalid case or study, and invalid options.
    pub(super) fn read(request: &JobRequest, workspace: &Workspace) -> Result<Self, JobError> {
        let files = InFolder { workspace, path: RefCell::default(), error: RefCell::default() };
        let prepared = request.job()?.prepare(&files);
        match (prepared, files.error.into_inner()) {
            (Ok(job), _) => Ok(Self { path: files.path.into_inner(), job }),
            (Err(_), Some(error)) => Err(error.into()),
            (Err(error), None) => Err(error.into()),
        }
    }
}

/// Files of the folder, by the ids in requests.
struct InFolder<'a> {
    workspace: &'a Workspace,
    /// Path of the case or the study.
    path: RefCell<String>,
    /// The folder's own error, if that was the reason of a failure.
    error: RefCell<Option<WorkspaceError>>,
}

impl InFolder<'_> {
    fn found<T>(&self, found: Result<T, WorkspaceError>) -> Result<T, Error> {
        found.map_err(|error| {
            let message = error.to_string();
            *self.error.borrow_mut() = Some(error);
            Error::BadInput(message)
        })
    }

    fn other(
        &self,
        files: Vec<OtherFile>,
        id: &Path,
        noun: &'static str,
    ) -> Result<(OtherFile, Vec<u8>), Error> {
        let file = self.found(Workspace::one_of(files, &id.to_string_lossy(), noun))?;
        let bytes = self.found(file.read())?;
        Ok((file, bytes))
    }
}

impl JobFiles for InFolder<'_> {
    fn case(&self, id: &Path) -> Result<CaseInput, Error> {
        let file = self.found(self.workspace.case(&id.to_string_lossy()))?;
        let text = self.found(file.read())?.text;
        let files = self.workspace.own_beside(&file.path);
        self.path.replace(file.shown.clone());
        Ok(CaseInput::new(&file.path, Template::with_files(&file.shown, &text, files)))
    }

    fn data(&self, id: &Path, _noun: &str) -> Result<DataInput, Error> {
        let (file, bytes) = self.other(self.workspace.readings(), id, "file of readings")?;
        Ok(DataInput { path: file.shown.into(), bytes })
    }

    fn study(&self, id: &Path) -> Result<Study, Error> {
        let (file, text) = self.other(self.workspace.studies(), id, "study")?;
        let study = study::parse(&file.shown, &text)?;
        self.path.replace(file.shown);
        Ok(study)
    }

    fn study_case(&self, id: &Path, name: &str) -> Result<Template, Error> {
        let (file, _) = self.other(self.workspace.studies(), id, "study")?;
        let folder = file.path.parent().unwrap_or(self.workspace.root());
        let unread = |error| Error::BadInput(format!("the case `{name}`: {error}"));
        let path = self.workspace.inside(&folder.join(name)).map_err(unread)?;
        let bytes = wholestring_case::read_file(&path).map_err(unread)?;
        let files = self.workspace.own_beside(&path);
        Ok(Template::with_files(name, &String::from_utf8_lossy(&bytes), files))
    }
}

// The request of a job: a command of the program on a saved case.

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

// Reasons why work is refused.

/// Reason why work is refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum JobError {
    /// The case, or the study, is invalid.
    #[error("the case is not valid")]
    Unsound(Report),
    /// The request is invalid.
    #[error("{0}")]
    BadInput(String),
    /// The request is not possible at present.
    #[error("{0}")]
    Conflict(String),
    /// The folder refuses.
    #[error(transparent)]
    Workspace(#[from] WorkspaceError),
}

impl From<Report> for JobError {
    fn from(report: Report) -> Self {
        Self::Unsound(report)
    }
}

impl From<Error> for JobError {
    fn from(error: Error) -> Self {
        match error {
            Error::Unsound(mut unsound) if unsound.reports.len() == 1 => {
                Self::Unsound(unsound.reports.remove(0))
            }
            error => Self::BadInput(error.to_string()),
        }
    }
}
