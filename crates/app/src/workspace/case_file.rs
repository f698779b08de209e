//! A case file of the folder.

use std::{fs, io, path::PathBuf, time::SystemTime};

use super::{error::WorkspaceError, folder::Workspace, name, write};
use crate::fingerprint::fingerprint;

/// A case file of the folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseFile {
    /// Identifier in requests, made from its path in the folder and unchanged while the path is.
    pub(crate) id: String,
    /// Path within the folder, with forward slashes, for display.
    pub(crate) shown: String,
    /// Path on disk.
    pub(crate) path: PathBuf,
    /// Time of its last change.
    pub(crate) modified: SystemTime,
}

/// Contents of a case file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CaseText {
    /// Its text, without a byte order mark.
    pub(crate) text: String,
    /// Fingerprint of the contents at that time.
    pub(crate) revision: String,
}

/// A file to create.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NewFile<'a> {
    /// Its name, without a path.
    pub(crate) name: &'a str,
    /// Its contents.
    pub(crate) text: &'a str,
}

impl CaseFile {
    /// Reads its contents.
    ///
    /// # Errors
    /// Errors of the system, and contents that are not text.
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
    /// Returns the case with an id.
    ///
    /// # Errors
    /// No case of the folder has it.
    pub(crate) fn case(&self, id: &str) -> Result<CaseFile, WorkspaceError> {
        let found = self.cases().into_iter().find(|case| case.id == id);
        found.ok_or(WorkspaceError::Nothing("case"))
    }

    /// Replaces the text of a case that is still at `revision`, and returns the new revision. Its
    /// draft is removed.
    ///
    /// # Errors
    /// The file has changed since, and errors of the system.
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

    /// Creates a case file and the files that it names, all or nothing.
    ///
    /// # Errors
    /// Names that no file may have, an existing file with other contents, and errors of the system.
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
            // Files of a case that could not be created are removed.
            made.iter().for_each(|path| drop(fs::remove_file(path)));
            return Err(error);
        }
        Ok(id_of(case.name))
    }
}

/// Identifier in requests for a path of the folder.
pub(super) fn id_of(shown: &str) -> String {
    fingerprint(shown.as_bytes())
}

/// Time of the last change of a file; 1970 if it is unknown.
pub(super) fn modified(about: &fs::Metadata) -> SystemTime {
    about.modified().unwrap_or(SystemTime::UNIX_EPOCH)
}
