//! Saved live strings, drafts and records of jobs: stored in `.wholestring`, one file each.

use std::{
    fs::{self, File, TryLockError},
    io,
    path::PathBuf,
    time::{SystemTime, UNIX_EPOCH},
};

use serde::{Deserialize, Serialize};

use super::{
    case_file::CaseFile,
    folder::{Workspace, WorkspaceError},
    own::{self, fingerprint},
};

/// Their folder.
const KEPT: [&str; 2] = [".wholestring", "live"];

/// The extension of the names.
const ENDING: &str = ".live";

/// Maximum number of files listed.
const MOST: usize = 200;

/// Maximum size of a saved string, bytes; larger files are ignored.
const LARGEST: u64 = 256 << 20;

/// A saved file.
#[derive(Debug, Clone)]
pub(crate) struct KeptFile {
    /// Identifier in requests.
    pub(crate) name: String,
    /// Time when it was saved, milliseconds since 1970.
    pub(crate) modified_ms: u64,
    path: PathBuf,
}

impl KeptFile {
    /// Reads its contents.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn read(&self) -> Result<Vec<u8>, WorkspaceError> {
        fs::read(&self.path).map_err(WorkspaceError::system("the saved string cannot be read"))
    }
}

impl Workspace {
    /// Saves these bytes, and returns their identifier in requests.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn keep(&self, bytes: &[u8]) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the string cannot be kept");
        let name = fingerprint(bytes);
        let _alone = self.writing();
        let mut folder = self.root().to_owned();
        for part in KEPT {
            folder.push(part);
            match fs::create_dir(&folder) {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => {
                    return Err(failed(error));
                }
                // Nothing is written through a link that leads out.
                _ => folder = self.inside(&folder).map_err(&failed)?,
            }
        }
        own::replace_file(&folder.join(format!("{name}{ENDING}")), bytes).map_err(&failed)?;
        Ok(name)
    }

    /// The saved files, the latest first.
    pub(crate) fn kept(&self) -> Vec<KeptFile> {
        let folder = KEPT.iter().fold(self.root().to_owned(), |path, name| path.join(name));
        let Ok(entries) = self.inside(&folder).and_then(fs::read_dir) else { return Vec::new() };
        let file = |entry: fs::DirEntry| {
            let name = entry.file_name().into_string().ok()?;
            let name = name.strip_suffix(ENDING)?.to_owned();
            let path = self.inside(&entry.path()).ok()?;
            let about = fs::metadata(&path).ok()?;
            let modified_ms = millis(about.modified().unwrap_or(SystemTime::UNIX_EPOCH));
            let is_ours = about.is_file() && about.len() <= LARGEST;
            is_ours.then_some(KeptFile { name, modified_ms, path })
        };
        let mut files: Vec<KeptFile> = entries.flatten().filter_map(file).collect();
        files.sort_by(|one, other| {
            other.modified_ms.cmp(&one.modified_ms).then_with(|| one.name.cmp(&other.name))
        });
        files.truncate(MOST);
        files
    }

    /// Returns the saved file with a name.
    ///
    /// # Errors
    /// No file has it.
    pub(crate) fn kept_file(&self, name: &str) -> Result<KeptFile, WorkspaceError> {
        let found = self.kept().into_iter().find(|file| file.name == name);
        found.ok_or(WorkspaceError::Nothing("kept string"))
    }

    /// Removes a saved file.
    ///
    /// # Errors
    /// No file has the name, and errors of the system.
    pub(crate) fn remove_kept(&self, name: &str) -> Result<(), WorkspaceError> {
        let path = self.kept_file(name)?.path;
        fs::remove_file(path).map_err(WorkspaceError::system("the string cannot be removed"))
    }
}

// Unsaved drafts: stored in `.wholestring/drafts`, one file for each case.

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
        own::replace_file(&path, &bytes).map_err(&failed)
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

// The records of jobs: stored in `.wholestring/jobs`, one file each.

/// The folder of the jobs.
const JOBS: &str = "jobs";

/// The file locked by the one server that runs the jobs of the folder.
const HELD: &str = "held";

impl Workspace {
    /// Makes this server the one that runs the jobs of this folder, until the returned file is
    /// dropped; returns none if another server is.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn hold_jobs(&self) -> Result<Option<File>, WorkspaceError> {
        let failed = WorkspaceError::system("work cannot be kept in the folder");
        let path = self.own_folder(JOBS).map_err(&failed)?.join(HELD);
        // Nothing is written through a link that leads out.
        let mut options = File::options();
        let file = options.read(true).write(true).create(true).truncate(false).open(path);
        let file = file.map_err(&failed)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(file)),
            Err(TryLockError::WouldBlock) => Ok(None),
            // A file system without locks excludes nobody.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                Ok(Some(file))
            }
            Err(TryLockError::Error(error)) => Err(failed(error)),
        }
    }

    /// Whether a job was ever started in the folder.
    pub(crate) fn has_jobs(&self) -> bool {
        self.own_path(JOBS).is_dir()
    }

    /// The saved records, one for each file; unreadable ones are skipped.
    pub(crate) fn kept_jobs(&self) -> Vec<Vec<u8>> {
        let entries = fs::read_dir(self.own_path(JOBS)).into_iter().flatten().flatten();
        let paths = entries.map(|entry| entry.path());
        let paths = paths.filter(|path| path.extension().is_some_and(|end| end == "json"));
        let inside = paths.filter_map(|path| self.inside(&path).ok());
        inside.filter_map(|path| wholestring_case::read_file(&path).ok()).collect()
    }

    /// Saves the record of a job.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn keep_job(&self, id: &str, bytes: &[u8]) -> Result<(), WorkspaceError> {
        let failed = WorkspaceError::system("the work cannot be kept in the folder");
        let folder = self.own_folder(JOBS).map_err(&failed)?;
        own::replace_file(&folder.join(format!("{id}.json")), bytes).map_err(&failed)
    }

    /// Forgets a job.
    pub(crate) fn forget_job(&self, id: &str) {
        let path: PathBuf = self.own_path(JOBS).join(format!("{id}.json"));
        if let Ok(path) = self.inside(&path) {
            // A file that cannot be removed is listed again at the next start.
            let _ = fs::remove_file(path);
        }
    }
}
