//! Unsaved drafts: stored in `.wholestring/drafts`, one file for each case.

use std::{
    fs, io,
    path::PathBuf,
    time::{SystemTime, UNIX_EPOCH},
};

use serde::{Deserialize, Serialize};

use super::{case_file::CaseFile, error::WorkspaceError, folder::Workspace, write};

/// An unsaved draft.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Draft {
    /// The text.
    pub(crate) text: String,
    /// The revision of the file when it was opened.
    pub(crate) base_revision: String,
    /// Time when it was saved.
    pub(crate) modified_ms: u64,
}

/// The folder of the drafts.
const DRAFTS: &str = "drafts";

impl Workspace {
    /// The draft of a case, if there is a readable one.
    pub(crate) fn draft(&self, case: &CaseFile) -> Option<Draft> {
        let path = self.inside(&self.draft_path(case)).ok()?;
        serde_json::from_slice(&wholestring_case::read_file(&path).ok()?).ok()
    }

    /// Saves a draft.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn keep_draft(
        &self,
        case: &CaseFile,
        text: String,
        base_revision: String,
    ) -> Result<(), WorkspaceError> {
        let failed = WorkspaceError::system("the draft cannot be kept");
        let draft = Draft { text, base_revision, modified_ms: millis(SystemTime::now()) };
        let bytes = serde_json::to_vec(&draft).map_err(io::Error::from).map_err(&failed)?;
        let _alone = self.writing();
        let folder = self.own_folder(DRAFTS).map_err(&failed)?;
        let path = folder.join(format!("{}.json", case.id));
        write::replace(&path, &bytes).map_err(&failed)
    }

    /// Removes the draft of a case, if there is one.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn remove_draft(&self, case: &CaseFile) -> Result<(), WorkspaceError> {
        let Ok(path) = self.inside(&self.draft_path(case)) else { return Ok(()) };
        fs::remove_file(path).map_err(WorkspaceError::system("the draft cannot be removed"))
    }

    fn draft_path(&self, case: &CaseFile) -> PathBuf {
        self.own_path(DRAFTS).join(format!("{}.json", case.id))
    }
}

/// Milliseconds since 1970.
pub(crate) fn millis(time: SystemTime) -> u64 {
    let since = time.duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_millis()).unwrap_or(u64::MAX)
}
