//! Files that are written whole or not at all.

use std::{
    fs,
    io::{self, Write},
    path::Path,
};

use tempfile::NamedTempFile;

/// Puts these bytes in the place of a file, or where none is.
pub(super) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let written = written_beside(path, bytes)?;
    if let Ok(about) = fs::metadata(path) {
        written.as_file().set_permissions(about.permissions())?;
    }
    written.persist(path)?;
    Ok(())
}

/// Makes a file of these bytes where none is.
///
/// # Errors
/// `AlreadyExists` where one is, and whatever the system says.
pub(super) fn create(path: &Path, bytes: &[u8]) -> io::Result<()> {
    written_beside(path, bytes)?.persist_noclobber(path)?;
    Ok(())
}

/// A file with these bytes in the folder of another, which goes where it is not given a name.
fn written_beside(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".wholestring-");
    // What the user's own programs would make it, not a secret.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(path.parent().unwrap_or(Path::new(".")))?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}
