//! The folder: which paths are inside it, and its contents.

use std::{
    borrow::Cow,
    fs, io,
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};

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

// Errors of the folder.

/// Error of the folder.
#[derive(Debug, thiserror::Error)]
pub(crate) enum WorkspaceError {
    /// The folder itself cannot be used.
    #[error("the folder {} cannot be used: {why}", path.display())]
    Folder {
        /// The path as given.
        path: PathBuf,
        /// The message of the system.
        why: String,
    },
    /// The id is unknown.
    #[error("there is no such {0} in the folder")]
    Nothing(&'static str),
    /// The file name is invalid.
    #[error("`{}` is no name for a file: {why}", name.escape_debug())]
    Name {
        /// The given name.
        name: String,
        /// Its mistake.
        why: Cow<'static, str>,
    },
    /// An existing file must not be overwritten.
    #[error("there is a file `{0}` already")]
    Exists(String),
    /// The file has changed since its text was read.
    #[error("the file has changed since it was opened")]
    Changed,
    /// The system refused.
    #[error("{what}: {source}")]
    System {
        /// The attempted operation: `the case cannot be read`.
        what: &'static str,
        /// The message of the system.
        source: io::Error,
    },
}

impl WorkspaceError {
    /// Converts an error of the system during this operation.
    pub(super) fn system(what: &'static str) -> impl Fn(io::Error) -> Self {
        move |source| Self::System { what, source }
    }
}

// The contents of the folder: files, and results folders, each of which counts as one entry.

/// Maximum depth of subfolders that are searched.
const DEPTH: usize = 4;

/// Maximum number of entries examined.
const ENTRIES: usize = 20_000;

/// Folders of generated files.
const SKIPPED: [&str; 2] = ["target", "node_modules"];

/// Files that identify a results folder; the last one exists from the start.
const RESULTS: [&str; 5] =
    ["summary.json", "sweep.csv", "checkpoint.bin", "point.json", ".wholestring"];

/// An entry of the folder.
#[derive(Debug)]
pub(super) struct Place {
    /// Path within the folder, with forward slashes.
    pub(super) shown: String,
    /// Path on disk.
    pub(super) path: PathBuf,
    /// Whether it is a results folder; a file otherwise.
    pub(super) holds_results: bool,
}

/// Whether a folder contains results, or those of work in progress.
pub(crate) fn holds_results(folder: &Path) -> bool {
    RESULTS.iter().any(|name| folder.join(name).is_file())
}

impl Workspace {
    /// All entries of the folder, the files of a folder before its subfolders. Names that begin
    /// with a dot, and links to folders, are skipped, because the targets are elsewhere in the
    /// folder or outside.
    pub(super) fn walk(&self) -> Vec<Place> {
        let mut found = Vec::new();
        let mut left = ENTRIES;
        walk(self.root(), "", 0, &mut left, &mut found);
        found
    }
}

fn walk(folder: &Path, above: &str, depth: usize, left: &mut usize, found: &mut Vec<Place>) {
    // An unreadable folder is treated as empty.
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut folders: Vec<(String, PathBuf)> = Vec::new();
    for entry in entries.flatten() {
        if *left == 0 {
            return;
        }
        *left -= 1;
        let (Ok(name), Ok(kind)) = (entry.file_name().into_string(), entry.file_type()) else {
            continue;
        };
        if name.starts_with('.') {
            continue;
        }
        let (shown, path) = (format!("{above}{name}"), entry.path());
        match kind.is_dir() {
            false => found.push(Place { shown, path, holds_results: false }),
            true if SKIPPED.contains(&name.as_str()) => {}
            true if holds_results(&path) => {
                found.push(Place { shown, path, holds_results: true });
            }
            true => folders.push((shown, path)),
        }
    }
    if depth == DEPTH {
        return;
    }
    folders.sort();
    for (shown, path) in folders {
        walk(&path, &format!("{shown}/"), depth + 1, left, found);
    }
}
