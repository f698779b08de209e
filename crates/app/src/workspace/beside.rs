//! Files that a case names, read only inside the folder.

use std::{
    collections::BTreeMap,
    io,
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
};

use wholestring_case::{Files, read_file};

use super::{
    case_file::CaseFile,
    folder::{Workspace, inside},
};

/// Files that a case names, from its own folder; none from outside the workspace.
#[derive(Debug)]
pub(crate) struct Beside<'a> {
    workspace: &'a Workspace,
    /// The folder of the case.
    folder: PathBuf,
    read: Mutex<BTreeMap<String, Vec<u8>>>,
}

impl Beside<'_> {
    /// The files that were read, by their names in the case.
    pub(crate) fn into_files(self) -> BTreeMap<String, Vec<u8>> {
        self.read.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Files for Beside<'_> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = read_file(&self.workspace.inside(&self.folder.join(name))?)?;
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        read.insert(name.to_owned(), bytes.clone());
        Ok(bytes)
    }
}

/// The same with shared ownership, because a job reads the files of its case when it needs them.
#[derive(Debug)]
pub(crate) struct OwnBeside {
    root: PathBuf,
    folder: PathBuf,
}

impl Files for OwnBeside {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        read_file(&inside(&self.root, &self.folder.join(name))?)
    }
}

impl Workspace {
    /// The files in the folder of a file, with shared ownership.
    pub(crate) fn own_beside(&self, file: &Path) -> OwnBeside {
        let folder = file.parent().unwrap_or(self.root()).to_owned();
        OwnBeside { root: self.root().to_owned(), folder }
    }

    /// The files in the folder of a case.
    pub(crate) fn beside(&self, case: &CaseFile) -> Beside<'_> {
        let folder = case.path.parent().unwrap_or(self.root()).to_owned();
        Beside { workspace: self, folder, read: Mutex::default() }
    }
}
