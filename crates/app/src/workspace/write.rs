//! Atomic writing of files.

use std::{
    fs,
    io::{self, Write},
    path::Path,
};

use tempfile::NamedTempFile;

/// Creates or replaces a file.
pub(super) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
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
pub(super) fn create(path: &Path, bytes: &[u8]) -> io::Result<()> {
    written_beside(path, bytes)?.persist_noclobber(path)?;
    Ok(())
}

/// A temporary file with these bytes in the folder of another file, deleted unless it is renamed.
fn written_beside(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".wholestring-");
    // The permissions of files made by the user's own programs, not those of a private file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(path.parent().unwrap_or(Path::new(".")))?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}
