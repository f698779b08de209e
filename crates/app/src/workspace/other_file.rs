//! Files other than cases: those that a case names, and those that a job uses in addition.

use std::{
    collections::BTreeMap,
    fs, io,
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
};

use wholestring_case::{Files, read_file};

use super::{
    case_file::{CaseFile, id_of, is_toml},
    folder::{Workspace, WorkspaceError, inside},
};

/// Maximum number of files listed.
const FILES: usize = 2000;

/// Extensions of files of readings.
const READINGS: [&str; 6] = [".csv", ".txt", ".tsv", ".xlsx", ".xls", ".ods"];

/// Maximum size of a study file, bytes: the reader refuses larger ones.
const LARGEST: u64 = 8 << 20;

/// A file of the folder.
#[derive(Debug, Clone)]
pub(crate) struct OtherFile {
    /// Identifier in requests.
    pub(crate) id: String,
    /// Path within the folder, with forward slashes.
    pub(crate) shown: String,
    /// Path on disk.
    pub(crate) path: PathBuf,
}

impl OtherFile {
    /// Reads its contents.
    ///
    /// # Errors
    /// Errors of the system, and a file that is too large.
    pub(crate) fn read(&self) -> Result<Vec<u8>, WorkspaceError> {
        wholestring_case::read_file(&self.path)
            .map_err(WorkspaceError::system("the file cannot be read"))
    }
}

impl Workspace {
    /// The study files, by path.
    pub(crate) fn studies(&self) -> Vec<OtherFile> {
        let is_study = |file: &OtherFile| {
            let text = file.path.metadata().and_then(|about| match about.len() > LARGEST {
                true => Err(io::Error::other("it is too long")),
                false => fs::read(&file.path),
            });
            text.is_ok_and(|text| has_sweep(&String::from_utf8_lossy(&text)))
        };
        self.files(is_toml).into_iter().filter(is_study).collect()
    }

    /// Files that may contain readings, by path.
    pub(crate) fn readings(&self) -> Vec<OtherFile> {
        self.files(|name| {
            let name = name.to_ascii_lowercase();
            READINGS.iter().any(|ending| name.ends_with(ending))
        })
    }

    /// Returns the one of these files with an id.
    ///
    /// # Errors
    /// No file has it; `noun` names the kind of file.
    pub(crate) fn one_of(
        files: Vec<OtherFile>,
        id: &str,
        noun: &'static str,
    ) -> Result<OtherFile, WorkspaceError> {
        let mut files = files.into_iter();
        files.find(|file| file.id == id).ok_or(WorkspaceError::Nothing(noun))
    }

    fn files(&self, is_wanted: impl Fn(&str) -> bool) -> Vec<OtherFile> {
        let places = self.walk().into_iter();
        let files = places.filter(|place| !place.holds_results && is_wanted(&place.shown));
        let files = files.take(FILES).filter_map(|place| {
            let path = self.inside(&place.path).ok().filter(|path| path.is_file())?;
            Some(OtherFile { id: id_of(&place.shown), shown: place.shown, path })
        });
        let mut found: Vec<OtherFile> = files.collect();
        found.sort_by(|one, other| one.shown.cmp(&other.shown));
        found
    }
}

/// Whether a text has a sweep, as every study has.
fn has_sweep(text: &str) -> bool {
    let lines = text.lines().map(str::trim_start);
    let mut headings = lines.filter_map(|line| line.strip_prefix("[["));
    headings.any(|heading| heading.trim_start().starts_with("sweep"))
}

// Files that a case names, read only inside the folder.

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
