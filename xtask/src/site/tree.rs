//! Files of the sources and of the site.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::{command::Failure, folders::root};

/// The book's pages with their texts.
pub(super) fn pages() -> Result<Vec<(PathBuf, String)>, Failure> {
    files(&root().join("docs/src"), "md")
}

/// Files with an extension in a folder and its subfolders, in order, with their texts.
pub(super) fn files(folder: &Path, extension: &str) -> Result<Vec<(PathBuf, String)>, Failure> {
    let cannot = |path: &Path, error| Failure::new(format!("{}: {error}", path.display()));
    let mut found = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).map_err(|error| cannot(&folder, error))? {
            let path = entry.map_err(|error| cannot(&folder, error))?.path();
            // Packages that npm installs are skipped.
            if path.is_dir() && !path.ends_with("node_modules") {
                folders.push(path);
            } else if path.extension().is_some_and(|other| other == extension) {
                let text = fs::read_to_string(&path).map_err(|error| cannot(&path, error))?;
                found.push((path, text));
            }
        }
    }
    found.sort();
    Ok(found)
}

/// Path of a file that another one names relative to its own folder.
pub(super) fn relative(source: &Path, file: &str) -> PathBuf {
    let mut path = source.parent().unwrap_or(source).to_path_buf();
    for step in file.split('/') {
        if step == ".." {
            path.pop();
        } else {
            path.push(step);
        }
    }
    path
}
