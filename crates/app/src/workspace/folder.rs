//! The folder, and which paths are inside it.

use std::{
    io,
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};

use super::error::WorkspaceError;

/// A folder that confines all access, links included.
#[derive(Debug)]
pub(crate) struct Workspace {
    /// Canonical path, without links.
    root: PathBuf,
    /// Locked while a file is compared and then written.
    writing: Mutex<()>,
}

impl Workspace {
    /// Opens the folder at a path.
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

    /// Locks out other writers.
    pub(super) fn writing(&self) -> MutexGuard<'_, ()> {
        // Files are written atomically: a panic leaves none half written.
        self.writing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Path of the folder.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// Name of the folder.
    pub(crate) fn name(&self) -> String {
        let name = self.root.file_name().unwrap_or(self.root.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// The canonical path, links followed, if it is inside the folder.
    ///
    /// # Errors
    /// Errors of the system for a missing path, and a sentence for one that leads out.
    pub(crate) fn inside(&self, path: &Path) -> io::Result<PathBuf> {
        inside(&self.root, path)
    }
}

/// The same for a canonical folder.
pub(super) fn inside(root: &Path, path: &Path) -> io::Result<PathBuf> {
    let real = path.canonicalize()?;
    match real.starts_with(root) {
        true => Ok(real),
        false => Err(outside()),
    }
}

/// The error for a path that leads out of the folder.
pub(super) fn outside() -> io::Error {
    let sentence = "it is outside the folder that the program was started for";
    io::Error::new(io::ErrorKind::PermissionDenied, sentence)
}
