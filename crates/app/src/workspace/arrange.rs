//! Renaming, copying and deleting case files.

use std::{fs, io, path::PathBuf};

use super::{
    case_file::{CaseFile, id_of},
    error::WorkspaceError,
    folder::Workspace,
    name, write,
};
use crate::fingerprint::fingerprint;

impl Workspace {
    /// Renames a case file and its draft within its folder. Returns its new id.
    ///
    /// # Errors
    /// A name that no case may have, an existing file, and errors of the system.
    pub(crate) fn rename(
        &self,
        case: &CaseFile,
        file_name: &str,
    ) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be renamed");
        let (shown, path) = self.neighbour(case, file_name)?;
        let draft = self.draft(case);
        {
            let _alone = self.writing();
            if fs::symlink_metadata(&path).is_ok() {
                return Err(WorkspaceError::Exists(file_name.to_owned()));
            }
            fs::rename(self.entry(case), &path).map_err(&failed)?;
        }
        let id = id_of(&shown);
        if let Some(draft) = draft {
            let renamed = CaseFile { id: id.clone(), shown, path, ..case.clone() };
            self.keep_draft(&renamed, draft.text, draft.base_revision)?;
            self.remove_draft(case)?;
        }
        Ok(id)
    }

    /// Copies a case file, as saved on disk, within its folder. Returns the new id.
    ///
    /// # Errors
    /// A name that no case may have, an existing file, and errors of the system.
    pub(crate) fn copy(&self, case: &CaseFile, file_name: &str) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be copied");
        let (shown, path) = self.neighbour(case, file_name)?;
        let _alone = self.writing();
        let bytes = fs::read(&case.path).map_err(&failed)?;
        write::create(&path, &bytes).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => WorkspaceError::Exists(file_name.to_owned()),
            _ => failed(error),
        })?;
        Ok(id_of(&shown))
    }

    /// Removes a case file that is still at `revision`, and its draft. The files that it names
    /// stay, because other cases may name them, too.
    ///
    /// # Errors
    /// The file has changed since, and errors of the system.
    pub(crate) fn remove(&self, case: &CaseFile, revision: &str) -> Result<(), WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be deleted");
        let _alone = self.writing();
        let now = fs::read(&case.path).map_err(&failed)?;
        if fingerprint(&now) != revision {
            return Err(WorkspaceError::Changed);
        }
        fs::remove_file(self.entry(case)).map_err(&failed)?;
        self.remove_draft(case)
    }

    /// The path of a file with this name in the folder of a case: for display, and on disk.
    fn neighbour(
        &self,
        case: &CaseFile,
        file_name: &str,
    ) -> Result<(String, PathBuf), WorkspaceError> {
        name::check_case(file_name)?;
        let shown = match case.shown.rsplit_once('/') {
            Some((folder, _)) => format!("{folder}/{file_name}"),
            None => file_name.to_owned(),
        };
        let path = self.root().join(&shown);
        Ok((shown, path))
    }

    /// The directory entry itself: for a link the link, not its target.
    fn entry(&self, case: &CaseFile) -> PathBuf {
        self.root().join(&case.shown)
    }
}
