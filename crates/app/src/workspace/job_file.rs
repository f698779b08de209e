//! What is known of work that was started: kept in `.wholestring/jobs`, a file for each.

use std::{
    fs::{self, File, TryLockError},
    io,
    path::PathBuf,
};

use super::{error::WorkspaceError, folder::Workspace, write};

/// The folder of the jobs.
const JOBS: &str = "jobs";

/// The file that the one server holds that does the work of the folder.
const HELD: &str = "held";

impl Workspace {
    /// Becomes the one server that does the work of this folder, until what is given is dropped;
    /// nothing where another is.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn hold_jobs(&self) -> Result<Option<File>, WorkspaceError> {
        let failed = WorkspaceError::system("work cannot be kept in the folder");
        let path = self.own_folder(JOBS).map_err(&failed)?.join(HELD);
        // Where it is a link that leads out, nothing is written through it.
        let mut options = File::options();
        let file = options.read(true).write(true).create(true).truncate(false).open(path);
        let file = file.map_err(&failed)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(file)),
            Err(TryLockError::WouldBlock) => Ok(None),
            // A file system without locks keeps nobody out.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                Ok(Some(file))
            }
            Err(TryLockError::Error(error)) => Err(failed(error)),
        }
    }

    /// Whether work was ever started in the folder.
    pub(crate) fn has_jobs(&self) -> bool {
        self.own_path(JOBS).is_dir()
    }

    /// What is kept, file after file; what cannot be read is left out.
    pub(crate) fn kept_jobs(&self) -> Vec<Vec<u8>> {
        let entries = fs::read_dir(self.own_path(JOBS)).into_iter().flatten().flatten();
        let paths = entries.map(|entry| entry.path());
        let paths = paths.filter(|path| path.extension().is_some_and(|end| end == "json"));
        let inside = paths.filter_map(|path| self.inside(&path).ok());
        inside.filter_map(|path| wholestring_case::read_file(&path).ok()).collect()
    }

    /// Keeps what is known of a job.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn keep_job(&self, id: &str, bytes: &[u8]) -> Result<(), WorkspaceError> {
        let failed = WorkspaceError::system("the work cannot be kept in the folder");
        let folder = self.own_folder(JOBS).map_err(&failed)?;
        write::replace(&folder.join(format!("{id}.json")), bytes).map_err(&failed)
    }

    /// Forgets a job.
    pub(crate) fn forget_job(&self, id: &str) {
        let path: PathBuf = self.own_path(JOBS).join(format!("{id}.json"));
        if let Ok(path) = self.inside(&path) {
            // Where it stays it is listed again at the next start.
            let _ = fs::remove_file(path);
        }
    }
}
