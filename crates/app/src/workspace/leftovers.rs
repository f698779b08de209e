//! Temporary files of servers that were killed while they wrote.

use std::{
    collections::BTreeSet,
    fs::{self, DirEntry, File},
    path::{Path, PathBuf},
};

use super::{
    folder::Workspace,
    own::{ENDING, OWN, PREFIX, TEMPORARY},
};

/// The names of unnamed files, where a system has none: `.tmpAbC123`.
const UNNAMED: &str = ".tmp";

/// Number of random letters and digits in both.
const RANDOM: usize = 6;

/// Maximum number of entries examined.
const ENTRIES: usize = 20_000;

impl Workspace {
    /// Removes the temporary files of servers that no longer run: in the folders of files, in the
    /// root, and in the internal folder. Files in use are locked and stay; so does whatever has
    /// another name or is no file. Errors are ignored, because the next start tries again.
    pub(crate) fn remove_leftovers(&self) {
        let own = self.root().join(OWN);
        let inner = fs::read_dir(&own).into_iter().flatten().flatten().map(|entry| entry.path());
        let files = self.walk().into_iter().filter(|place| !place.holds_results);
        let folders = files.filter_map(|place| Some(place.path.parent()?.to_owned()));
        let root = [self.root().to_owned()];
        let folders: BTreeSet<PathBuf> = folders.chain(inner).chain(root).collect();
        // Nothing is removed through a link that leads out.
        for folder in folders.iter().filter_map(|folder| self.inside(folder).ok()) {
            let unnamed = folder == own.join(TEMPORARY);
            let entries = fs::read_dir(&folder).into_iter().flatten().flatten().take(ENTRIES);
            for entry in entries.filter(|entry| is_temporary(entry, unnamed)) {
                remove_unused(&entry.path());
            }
        }
    }
}

/// Whether it is a file, and no link, with the name of a temporary file.
fn is_temporary(entry: &DirEntry, unnamed: bool) -> bool {
    let (Ok(name), Ok(kind)) = (entry.file_name().into_string(), entry.file_type()) else {
        return false;
    };
    let written = name.strip_prefix(PREFIX).and_then(|name| name.strip_suffix(ENDING));
    let unnamed = name.strip_prefix(UNNAMED).filter(|_| unnamed);
    let random = written.or(unnamed).unwrap_or_default();
    let is_random = random.len() == RANDOM && random.bytes().all(|b| b.is_ascii_alphanumeric());
    is_random && kind.is_file()
}

/// Removes a file unless a program has locked it. The lock of a killed program ends with it.
fn remove_unused(path: &Path) {
    if File::open(path).is_ok_and(|file| file.try_lock().is_ok()) {
        let _ = fs::remove_file(path);
    }
}
