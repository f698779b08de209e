//! A case file of the folder.

use std::{fs, io, path::PathBuf, time::SystemTime};

use super::{error::WorkspaceError, folder::Workspace, name, write};
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

/// What stands in a case file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseText {
    /// Its text, without a byte order mark.
    pub(crate) text: String,
    /// What it is at that time: another text has another.
    pub(crate) revision: String,
}

/// A file that is to be made.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NewFile<'a> {
    /// Its name, no path.
    pub(crate) name: &'a str,
    /// What it holds.
    pub(crate) text: &'a str,
}

impl CaseFile {
    /// What stands in it.
    ///
    /// # Errors
    /// Whatever the system says, and what is no text.
    pub(crate) fn read(&self) -> Result<CaseText, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be read");
        let bytes = wholestring_case::read_file(&self.path).map_err(&failed)?;
        let revision = fingerprint(&bytes);
        let not_text = |_| failed(io::Error::other("it is not a text in UTF-8"));
        let text = String::from_utf8(bytes).map_err(not_text)?;
        let text = text.strip_prefix('\u{feff}').map_or_else(|| text.clone(), str::to_owned);
        Ok(CaseText { text, revision })
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

    /// Puts a text in the place of what the case had at `revision`, and gives the new revision. The
    /// draft of it goes.
    ///
    /// # Errors
    /// Where the file has become another since, and whatever the system says.
    pub(crate) fn save(
        &self,
        case: &CaseFile,
        text: &str,
        revision: &str,
    ) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the case cannot be saved");
        let _alone = self.writing();
        let now = fs::read(&case.path).map_err(&failed)?;
        if fingerprint(&now) != revision {
            return Err(WorkspaceError::Changed);
        }
        write::replace(&case.path, text.as_bytes()).map_err(&failed)?;
        self.remove_draft(case)?;
        Ok(fingerprint(text.as_bytes()))
    }

    /// Makes a case file and what it names beside it, all or nothing.
    ///
    /// # Errors
    /// Names that no file may have, a file that is there with another content, and whatever the
    /// system says.
    pub(crate) fn create(
        &self,
        case: NewFile<'_>,
        beside: &[NewFile<'_>],
    ) -> Result<String, WorkspaceError> {
        name::check_case(case.name)?;
        beside.iter().try_for_each(|file| name::check(file.name))?;
        let _alone = self.writing();
        let mut made = Vec::new();
        let all = beside.iter().map(|file| (file, true)).chain([(&case, false)]);
        for (file, may_be_there) in all {
            let path = self.root().join(file.name);
            let error = match write::create(&path, file.text.as_bytes()) {
                Ok(()) => {
                    made.push(path);
                    continue;
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                    let same = || fs::read(&path).is_ok_and(|now| now == file.text.as_bytes());
                    if may_be_there && self.inside(&path).is_ok() && same() {
                        continue;
                    }
                    WorkspaceError::Exists(file.name.to_owned())
                }
                Err(error) => WorkspaceError::system("the file cannot be written")(error),
            };
            // What was made for a case that is not there serves nobody.
            made.iter().for_each(|path| drop(fs::remove_file(path)));
            return Err(error);
        }
        Ok(id_of(case.name))
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
