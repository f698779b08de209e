//! What the app itself keeps in the folder: `.wholestring`.

use std::{
    fs::{self, File},
    io,
    path::PathBuf,
};

use super::{error::WorkspaceError, folder::Workspace};

/// The folder that is ours.
const OWN: &str = ".wholestring";

/// The folder of files that are being read.
const TEMPORARY: &str = "temporary";

impl Workspace {
    /// A file without a name, which goes when it is closed.
    ///
    /// # Errors
    /// Whatever the system says.
    pub(crate) fn temporary_file(&self) -> Result<File, WorkspaceError> {
        let file = self.own_folder(TEMPORARY).and_then(tempfile::tempfile_in);
        file.map_err(WorkspaceError::system("what arrives cannot be kept"))
    }

    /// Where something of ours lies, if it is there.
    pub(super) fn own_path(&self, name: &str) -> PathBuf {
        self.root().join(OWN).join(name)
    }

    /// A folder of ours, made where there is none.
    ///
    /// # Errors
    /// Whatever the system says, and a link that leads out.
    pub(super) fn own_folder(&self, name: &str) -> io::Result<PathBuf> {
        let mut folder = self.root().to_owned();
        for name in [OWN, name] {
            folder.push(name);
            match fs::create_dir(&folder) {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
                // A link that leads out is no place to write to.
                _ => folder = self.inside(&folder)?,
            }
        }
        Ok(folder)
    }
}
