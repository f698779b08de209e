//! The records of jobs: stored in `.wholestring/jobs`, one file each.

use std::{
    fs::{self, File, TryLockError},
    io,
    path::PathBuf,
};

use super::{error::WorkspaceError, folder::Workspace, write};

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
        write::replace(&folder.join(format!("{id}.json")), bytes).map_err(&failed)
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
