//! Links, as each system has them.

use std::{io, path::Path};

/// Makes `link` lead to `original`.
#[cfg(unix)]
pub fn symlink(original: impl AsRef<Path>, link: impl AsRef<Path>) -> io::Result<()> {
    std::os::unix::fs::symlink(original, link)
}

/// Makes `link` lead to `original`, by a link of its kind; the user must be allowed to make links.
#[cfg(windows)]
pub fn symlink(original: impl AsRef<Path>, link: impl AsRef<Path>) -> io::Result<()> {
    use std::os::windows::fs::{symlink_dir, symlink_file};
    if original.as_ref().is_dir() {
        symlink_dir(original, link)
    } else {
        symlink_file(original, link)
    }
}
