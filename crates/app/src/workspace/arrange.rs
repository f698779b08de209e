//! Case files that get another name, a copy, or go.

use std::{fs, io, path::PathBuf};

use super::{
    case_file::{CaseFile, id_of},
    error::WorkspaceError,
    folder::Workspace,
    name, write,
};
use crate::fingerprint::fingerprint;

impl Workspace {
    /// Gives a case file another name in its folder, and its draft with it. Gives its new id.
    ///
    /// # Errors
    /// A name that no case may have, a file that is there, and whatever the system says.
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

    /// Makes a copy of a case file beside it, as it is on the disk. Gives its id.
    ///
    /// # Errors
    /// A name that no case may have, a file that is there, and whatever the system says.
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

    /// Removes a case file as it was at `revision`, and its draft. What it names beside it stays:
    /// other cases may name it, too.
    ///
    /// # Errors
    /// Where the file has become another since, and whatever the system says.
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

    /// The place of a file of this name in the folder of a case: for the eye, and on the disk.
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

    /// The entry of the folder itself: of a link the link, not the file that it leads to.
    fn entry(&self, case: &CaseFile) -> PathBuf {
        self.root().join(&case.shown)
    }
}
