//! The inputs of a job, read at the time of its request, so that later changes of the files do not
//! affect it.

use std::{cell::RefCell, path::Path};

use wholestring_case::Template;
use wholestring_runner::{
    Error,
    job::{CaseInput, DataInput, JobFiles, PreparedJob},
    study::{self, Study},
};

use super::{error::JobError, request::JobRequest};
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
