//! Live strings that are kept to be continued: in `.wholestring/live`, a file each.

use std::{fs, io, path::PathBuf, time::SystemTime};

use super::{draft::millis, error::WorkspaceError, folder::Workspace, write};
use crate::{
    fingerprint::fingerprint,
    live::{KeptEntry, KeptString},
};

/// Where they are kept in the folder.
const KEPT: [&str; 2] = [".wholestring", "live"];

/// The ending of their names.
const ENDING: &str = ".live";

/// Files that are listed.
const MOST: usize = 200;

/// A file that is longer is none of ours, bytes.
const LARGEST: u64 = 256 << 20;

impl Workspace {
    /// Keeps a string, and gives what requests call it.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn keep_string(&self, kept: &KeptString) -> Result<String, WorkspaceError> {
        let failed = WorkspaceError::system("the string cannot be kept");
        let bytes = kept.bytes().map_err(&failed)?;
        let name = fingerprint(&bytes);
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
        write::replace(&folder.join(format!("{name}{ENDING}")), &bytes).map_err(&failed)?;
        Ok(name)
    }

    /// The files of kept strings: name, place and when they were changed.
    fn kept_files(&self) -> Vec<(String, PathBuf, SystemTime)> {
        let folder = KEPT.iter().fold(self.root().to_owned(), |path, name| path.join(name));
        let Ok(entries) = self.inside(&folder).and_then(fs::read_dir) else { return Vec::new() };
        let file = |entry: fs::DirEntry| {
            let name = entry.file_name().into_string().ok()?;
            let name = name.strip_suffix(ENDING)?.to_owned();
            let path = self.inside(&entry.path()).ok()?;
            let about = fs::metadata(&path).ok()?;
            let is_ours = about.is_file() && about.len() <= LARGEST;
            is_ours.then(|| (name, path, about.modified().unwrap_or(SystemTime::UNIX_EPOCH)))
        };
        let mut files: Vec<_> = entries.flatten().filter_map(file).collect();
        files.sort_by(|one, other| other.2.cmp(&one.2).then_with(|| one.0.cmp(&other.0)));
        files.truncate(MOST);
        files
    }

    /// The kept strings, the latest first.
    pub(crate) fn kept_strings(&self) -> Vec<KeptEntry> {
        let entry = |(name, path, modified): (String, PathBuf, SystemTime)| {
            let kept = KeptString::of_bytes(&fs::read(path).ok()?)?;
            Some(KeptEntry {
                name,
                case: kept.case_id,
                title: kept.name,
                operation: kept.operation,
                time_s: kept.time_s,
                modified_ms: millis(modified),
            })
        };
        self.kept_files().into_iter().filter_map(entry).collect()
    }

    /// The kept string of a name.
    ///
    /// # Errors
    /// Where none has it, and a file that is damaged.
    pub(crate) fn kept_string(&self, name: &str) -> Result<KeptString, WorkspaceError> {
        let failed = WorkspaceError::system("the string cannot be read");
        let found = self.kept_files().into_iter().find(|file| file.0 == name);
        let (_, path, _) = found.ok_or(WorkspaceError::Nothing("kept string"))?;
        let bytes = fs::read(path).map_err(&failed)?;
        let damaged = || failed(io::Error::other("the file is damaged"));
        KeptString::of_bytes(&bytes).ok_or_else(damaged)
    }

    /// Removes a kept string.
    ///
    /// # Errors
    /// Where none has the name, and whatever the system says.
    pub(crate) fn remove_kept_string(&self, name: &str) -> Result<(), WorkspaceError> {
        let found = self.kept_files().into_iter().find(|file| file.0 == name);
        let (_, path, _) = found.ok_or(WorkspaceError::Nothing("kept string"))?;
        fs::remove_file(path).map_err(WorkspaceError::system("the string cannot be removed"))
    }
}
