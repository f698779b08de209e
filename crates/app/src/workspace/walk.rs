//! The contents of the folder: files, and results folders, each of which counts as one entry.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::folder::Workspace;

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
