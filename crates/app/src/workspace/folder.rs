//! The folder, and which paths lie in it.

use std::{
    io,
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};

use super::error::WorkspaceError;

/// A folder that nothing leaves, links included.
#[derive(Debug)]
pub(crate) struct Workspace {
    /// As the system knows it: without links.
    root: PathBuf,
    /// Held by who looks at a file and writes it then.
    writing: Mutex<()>,
}

impl Workspace {
    /// The folder at a path.
    ///
    /// # Errors
    /// A path that leads to no folder.
    pub(crate) fn open(path: &Path) -> Result<Self, WorkspaceError> {
        let refused = |why: String| WorkspaceError::Folder { path: path.to_owned(), why };
        let root = path.canonicalize().map_err(|error| refused(error.to_string()))?;
        match root.is_dir() {
            true => Ok(Self { root, writing: Mutex::new(()) }),
            false => Err(refused("it is no folder".to_owned())),
        }
    }

    /// Nobody else writes while this is held.
    pub(super) fn writing(&self) -> MutexGuard<'_, ()> {
        // Files are written whole: who panicked has left none half written.
        self.writing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Where it lies.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// What it is called.
    pub(crate) fn name(&self) -> String {
        let name = self.root.file_name().unwrap_or(self.root.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// Where a path leads in the end, links followed, if that is in the folder.
    ///
    /// # Errors
    /// What the system says of a path that leads nowhere, and of one that leads out a sentence.
    pub(crate) fn inside(&self, path: &Path) -> io::Result<PathBuf> {
        inside(&self.root, path)
    }
}

/// The same of a folder that is known without links.
pub(super) fn inside(root: &Path, path: &Path) -> io::Result<PathBuf> {
    let real = path.canonicalize()?;
    match real.starts_with(root) {
        true => Ok(real),
        false => Err(outside()),
    }
}

/// The answer to what would leave the folder.
pub(super) fn outside() -> io::Error {
    let sentence = "it lies outside the folder that the program was started for";
    io::Error::new(io::ErrorKind::PermissionDenied, sentence)
}
