//! A page on disk that only its owner can read.
//!
//! The command line of a process is visible to all users of a machine. A browser is therefore
//! started with the path of a file, and the secret is in the file.

use std::{
    env,
    fs::{self, File, Metadata},
    io::{self, Write},
    path::{Path, PathBuf},
};

use tempfile::TempDir;

/// The name of the folder begins with this, and ends with six random letters and digits.
const PREFIX: &str = "wholestring-link-";
const RANDOM: usize = 6;

/// The page in the folder.
const PAGE: &str = "open.html";

/// A file that is locked while the server runs; a locked page could not be read on Windows.
const HELD: &str = "held";

/// Maximum number of entries of the temporary folder that are examined.
const ENTRIES: usize = 20_000;

/// A page in a folder of its own; both are deleted when this is dropped.
#[derive(Debug)]
pub(crate) struct LinkFile {
    /// Closed before the folder is deleted.
    _held: File,
    /// Mode 0700 on Unix; on Windows the temporary folder is the user's own.
    _folder: TempDir,
    path: PathBuf,
}

impl LinkFile {
    /// Writes the page.
    ///
    /// # Errors
    /// A temporary folder that cannot be written.
    pub(crate) fn new(page: &str) -> io::Result<Self> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(PREFIX).rand_bytes(RANDOM);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o700));
        let folder = builder.tempdir()?;
        let held = private(&folder.path().join(HELD))?;
        // Without locks, the folder of a killed server stays.
        let _ = held.try_lock();
        remove_leftovers(&env::temp_dir(), &folder.path().metadata()?);
        let path = folder.path().join(PAGE);
        private(&path)?.write_all(page.as_bytes())?;
        Ok(Self { _held: held, _folder: folder, path })
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }
}

/// Creates a file that nobody else can open.
fn private(path: &Path) -> io::Result<File> {
    let mut options = File::options();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options.open(path)
}

/// Removes the pages of killed servers from the temporary folder: those of this user, in which no
/// server holds the lock.
fn remove_leftovers(temporary: &Path, own: &Metadata) {
    let entries = fs::read_dir(temporary).into_iter().flatten().flatten().take(ENTRIES);
    for entry in entries {
        let name = entry.file_name();
        let random = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
        let is_ours = random.is_some_and(|random| random.len() == RANDOM);
        // The metadata of a directory entry do not follow links.
        let is_folder = || entry.metadata().is_ok_and(|about| about.is_dir() && same(&about, own));
        if !is_ours || !is_folder() {
            continue;
        }
        let folder = entry.path();
        let held = folder.join(HELD);
        if File::open(&held).is_ok_and(|held| held.try_lock().is_ok()) {
            // The folder last: with any other file in it, it stays.
            let _ = fs::remove_file(folder.join(PAGE));
            let _ = fs::remove_file(held);
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Whether two folders have the same owner: in a shared temporary folder, another user's may have
/// such a name.
#[cfg(unix)]
fn same(one: &Metadata, other: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    one.uid() == other.uid()
}

/// The temporary folder is the user's own.
#[cfg(not(unix))]
fn same(_: &Metadata, _: &Metadata) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_of_killed_servers_are_removed_and_nothing_else_is() {
        let temporary = tempfile::tempdir().unwrap();
        let folder = |name: &str, files: &[&str]| {
            let folder = temporary.path().join(name);
            fs::create_dir(&folder).unwrap();
            files.iter().for_each(|file| fs::write(folder.join(file), "").unwrap());
            folder
        };
        let dead = folder("wholestring-link-aB3dE6", &[PAGE, HELD]);
        let used = folder("wholestring-link-000000", &[PAGE, HELD]);
        let other = folder("wholestring-link-notes", &[PAGE, HELD]);
        let more = folder("wholestring-link-111111", &[PAGE, HELD, "notes.txt"]);
        let held = File::open(used.join(HELD)).unwrap();
        held.try_lock().unwrap();
        remove_leftovers(temporary.path(), &temporary.path().metadata().unwrap());
        assert!(!dead.exists());
        assert!(used.join(PAGE).exists() && other.join(PAGE).exists());
        assert!(more.join("notes.txt").exists());
    }
}
