//! A patch: a head in words, then its difference.

use std::{ffi::OsStr, fs, io, path::Path};

use super::places::PATCHES;

/// Beginning of a file's part of the difference.
const BEGIN: &str = "diff --git ";

/// Beginning of a line of the head with tests: the arguments of `cargo test --workspace` follow.
const TESTS: &str = "Tests: ";

pub(super) struct Patch {
    /// Its file's name, without the extension.
    pub(super) name: String,
    /// Text above the difference.
    pub(super) head: String,
    /// The files that it changes.
    pub(super) files: Vec<String>,
}

impl Patch {
    /// The patches of a folder, by name.
    pub(super) fn all_in(folder: &Path) -> io::Result<Vec<Self>> {
        let entries: io::Result<Vec<_>> = fs::read_dir(folder)?.collect();
        let mut paths: Vec<_> = entries?.iter().map(fs::DirEntry::path).collect();
        paths.retain(|path| path.extension() == Some(OsStr::new("patch")));
        paths.sort();
        let read = |path: &std::path::PathBuf| {
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            Ok(Self::parse(&name, &fs::read_to_string(path)?))
        };
        paths.iter().map(read).collect()
    }

    pub(super) fn parse(name: &str, text: &str) -> Self {
        let start = match text.starts_with(BEGIN) {
            true => 0,
            false => text.find(&format!("\n{BEGIN}")).map_or(text.len(), |end| end + 1),
        };
        let (head, difference) = text.split_at(start);
        let file = |line: &str| Some(line.strip_prefix(BEGIN)?.split_once(" b/")?.1.to_owned());
        Self {
            name: name.to_owned(),
            head: head.to_owned(),
            files: difference.lines().filter_map(file).collect(),
        }
    }

    /// Its path, from the root of the repository.
    pub(super) fn file(&self) -> String {
        format!("{}/{}.patch", PATCHES, self.name)
    }

    /// The sources that have to be written by hand.
    pub(super) fn by_hand(&self) -> Vec<&str> {
        self.files.iter().map(String::as_str).filter(|file| is_by_hand(file)).collect()
    }

    /// Arguments of `cargo test --workspace`, for each line of tests in the head.
    pub(super) fn tests(&self) -> impl Iterator<Item = &str> {
        self.head.lines().filter_map(|line| line.strip_prefix(TESTS))
    }
}

/// Whether a file counts: output of commands (the lock file, snapshots) does not, nor do tests and
/// pages, which every change has.
fn is_by_hand(file: &str) -> bool {
    let is_test = file.split('/').any(|part| part == "tests" || part == "tests.rs");
    let is_written = file.ends_with(".lock") || file.ends_with(".snap");
    !is_test && !is_written && !file.ends_with(".md")
}
