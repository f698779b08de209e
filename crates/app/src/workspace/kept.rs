//! Saved live strings: stored in `.wholestring/live`, one file each.

use std::{fs, io, path::PathBuf, time::SystemTime};

use super::{draft::millis, error::WorkspaceError, folder::Workspace, write};
use crate::fingerprint::fingerprint;

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
        write::replace(&folder.join(format!("{name}{ENDING}")), bytes).map_err(&failed)?;
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
