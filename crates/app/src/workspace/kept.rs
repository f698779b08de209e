//! What is kept of live strings: in `.wholestring/live`, a file each.

use std::{fs, io, path::PathBuf, time::SystemTime};

use super::{draft::millis, error::WorkspaceError, folder::Workspace, write};
use crate::fingerprint::fingerprint;

/// Where it is kept in the folder.
const KEPT: [&str; 2] = [".wholestring", "live"];

/// The ending of the names.
const ENDING: &str = ".live";

/// Files that are listed.
const MOST: usize = 200;

/// A file that is longer is none of ours, bytes.
const LARGEST: u64 = 256 << 20;

/// A file that is kept.
#[derive(Debug, Clone)]
pub(crate) struct KeptFile {
    /// What requests call it.
    pub(crate) name: String,
    /// When it was kept, milliseconds since 1970.
    pub(crate) modified_ms: u64,
    path: PathBuf,
}

impl KeptFile {
    /// What is in it.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn read(&self) -> Result<Vec<u8>, WorkspaceError> {
        fs::read(&self.path).map_err(WorkspaceError::system("what was kept cannot be read"))
    }
}

impl Workspace {
    /// Keeps these bytes, and gives what requests call them.
    ///
    /// # Errors
    /// Whatever the system says.
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
                // A link that leads out is no place to write to.
                _ => folder = self.inside(&folder).map_err(&failed)?,
            }
        }
        write::replace(&folder.join(format!("{name}{ENDING}")), bytes).map_err(&failed)?;
        Ok(name)
    }

    /// What is kept, the latest first.
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

    /// The kept file of a name.
    ///
    /// # Errors
    /// Where none has it.
    pub(crate) fn kept_file(&self, name: &str) -> Result<KeptFile, WorkspaceError> {
        let found = self.kept().into_iter().find(|file| file.name == name);
        found.ok_or(WorkspaceError::Nothing("kept string"))
    }

    /// Removes a kept file.
    ///
    /// # Errors
    /// Where none has the name, and whatever the system says.
    pub(crate) fn remove_kept(&self, name: &str) -> Result<(), WorkspaceError> {
        let path = self.kept_file(name)?.path;
        fs::remove_file(path).map_err(WorkspaceError::system("the string cannot be removed"))
    }
}
