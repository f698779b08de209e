//! What lies in the folder: files, and folders of results, each of which counts as one.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::folder::Workspace;

/// Folders below the folder that are searched.
const DEPTH: usize = 4;

/// Entries that are looked at.
const ENTRIES: usize = 20_000;

/// Folders that hold what programs make.
const SKIPPED: [&str; 2] = ["target", "node_modules"];

/// Files by one of which a folder of results is known, the last from its first moment on.
const RESULTS: [&str; 5] =
    ["summary.json", "sweep.csv", "checkpoint.bin", "point.json", ".wholestring"];

/// Something that lies in the folder.
#[derive(Debug)]
pub(super) struct Place {
    /// Its place in the folder, with forward slashes.
    pub(super) shown: String,
    /// Where it is.
    pub(super) path: PathBuf,
    /// Whether it is a folder of results; a file otherwise.
    pub(super) holds_results: bool,
}

/// Whether a folder holds results, or those of work that goes on.
pub(crate) fn holds_results(folder: &Path) -> bool {
    RESULTS.iter().any(|name| folder.join(name).is_file())
}

impl Workspace {
    /// All that lies in the folder, files of a folder before what lies deeper. What begins with a
    /// dot, and links to folders, are left out: what these lead to lies elsewhere in the folder, or
    /// outside.
    pub(super) fn walk(&self) -> Vec<Place> {
        let mut found = Vec::new();
        let mut left = ENTRIES;
        walk(self.root(), "", 0, &mut left, &mut found);
        found
    }
}

fn walk(folder: &Path, above: &str, depth: usize, left: &mut usize, found: &mut Vec<Place>) {
    // A folder that may not be read holds nothing for us.
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
