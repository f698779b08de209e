//! Internal files of the app in the folder: `.wholestring`.

use std::{
    fs::{self, File},
    io,
    path::PathBuf,
};

use super::{error::WorkspaceError, folder::Workspace};

/// The internal folder.
const OWN: &str = ".wholestring";

/// The folder of files that are being read.
const TEMPORARY: &str = "temporary";

impl Workspace {
    /// Creates a temporary file without a name, deleted when it is closed.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn temporary_file(&self) -> Result<File, WorkspaceError> {
        let file = self.own_folder(TEMPORARY).and_then(tempfile::tempfile_in);
        file.map_err(WorkspaceError::system("the upload cannot be stored"))
    }

    /// Path of an internal file or folder.
    pub(super) fn own_path(&self, name: &str) -> PathBuf {
        self.root().join(OWN).join(name)
    }

    /// Returns an internal folder, created if missing.
    ///
    /// # Errors
    /// Errors of the system, and a link that leads out.
    pub(super) fn own_folder(&self, name: &str) -> io::Result<PathBuf> {
        let mut folder = self.root().to_owned();
        for name in [OWN, name] {
            folder.push(name);
            match fs::create_dir(&folder) {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
                // Nothing is written through a link that leads out.
                _ => folder = self.inside(&folder)?,
            }
        }
        Ok(folder)
    }
}
