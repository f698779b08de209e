//! Internal files of the app in the folder, `.wholestring`, and atomic writing of files.

use std::{
    fs::{self, File},
    io::{self, Write},
    path::{Path, PathBuf},
};

use sha1::{Digest, Sha1};
use tempfile::NamedTempFile;

use super::folder::{Workspace, WorkspaceError};

/// The internal folder.
pub(super) const OWN: &str = ".wholestring";

/// The folder of files that are being read.
pub(super) const TEMPORARY: &str = "temporary";

impl Workspace {
    /// Creates a temporary file without a name, deleted when it is closed.
    ///
    /// # Errors
    /// Errors of the system.
    pub(crate) fn temporary_file(&self) -> Result<File, WorkspaceError> {
        let file = self.own_folder(TEMPORARY).and_then(tempfile::tempfile_in);
        // Where a file cannot be without a name, the lock shows that it is in use.
        let file = file.inspect(|file| drop(file.try_lock()));
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

// Atomic writing of files.

/// The names of files that are being written: `.wholestring-AbC123.part`.
pub(super) const PREFIX: &str = ".wholestring-";
pub(super) const ENDING: &str = ".part";

/// Creates or replaces a file.
pub(super) fn replace_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let written = written_beside(path, bytes)?;
    if let Ok(about) = fs::metadata(path) {
        written.as_file().set_permissions(about.permissions())?;
    }
    written.persist(path)?;
    Ok(())
}

/// Creates a new file.
///
/// # Errors
/// `AlreadyExists` if the file exists, and errors of the system.
pub(super) fn create_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    written_beside(path, bytes)?.persist_noclobber(path)?;
    Ok(())
}

/// A temporary file with these bytes in the folder of another file, deleted unless it is renamed.
fn written_beside(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(ENDING);
    // The permissions of files made by the user's own programs, not those of a private file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(path.parent().unwrap_or(Path::new(".")))?;
    // Until it is closed, so that no other server takes it for a left-over file. Without locks,
    // none is removed.
    let _ = file.as_file().try_lock();
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}

// A short identifier of bytes: equal for equal bytes, on every machine.

/// Sixteen hexadecimal digits, which distinguish contents but are not cryptographic.
pub(crate) fn fingerprint(bytes: &[u8]) -> String {
    Sha1::digest(bytes).iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}
