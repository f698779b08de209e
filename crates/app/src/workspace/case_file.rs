//! A case file of the folder.

use std::{fs, path::PathBuf, time::SystemTime};

use super::{error::WorkspaceError, folder::Workspace};
use crate::fingerprint::fingerprint;

/// A case file of the folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseFile {
    /// What requests call it: it is made of its place in the folder, and stays while that stays.
    pub(crate) id: String,
    /// Its place in the folder, with forward slashes, for the eye.
    pub(crate) shown: String,
    /// Where it is.
    pub(crate) path: PathBuf,
    /// When it was changed.
    pub(crate) modified: SystemTime,
}

impl CaseFile {
    /// The text that stands in it. What is no text is shown as far as it is.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn read(&self) -> Result<String, WorkspaceError> {
        let what = "the case cannot be read";
        let bytes = wholestring_case::read_file(&self.path);
        let bytes = bytes.map_err(|source| WorkspaceError::System { what, source })?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl Workspace {
    /// The case of an id.
    ///
    /// # Errors
    /// Where no case of the folder has it.
    pub(crate) fn case(&self, id: &str) -> Result<CaseFile, WorkspaceError> {
        let found = self.cases().into_iter().find(|case| case.id == id);
        found.ok_or(WorkspaceError::Nothing("case"))
    }
}

/// What requests call a place of the folder.
pub(super) fn id_of(shown: &str) -> String {
    fingerprint(shown.as_bytes())
}

/// When a file was changed; where nobody knows, long ago.
pub(super) fn modified(about: &fs::Metadata) -> SystemTime {
    about.modified().unwrap_or(SystemTime::UNIX_EPOCH)
}
