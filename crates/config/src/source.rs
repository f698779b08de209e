//! Texts that diagnostics refer to, and the source of files next to the case.

use std::{
    io::{self, Read},
    path::{Path, PathBuf},
};

/// A text that a diagnostic can quote: the case file, a `--set` argument, a survey.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Its name for the user: a file's name, or `command line`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The name of a source that is an argument of the command.
pub const COMMAND_LINE: &str = "command line";

/// A range of one source, in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Span {
    /// Index of the source in its [`Report`](crate::diagnostic::Report).
    pub source: usize,
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

/// Source of the files that a case names.
pub trait Files {
    /// The contents of the file at `path`, as written in the case.
    fn read(&self, path: &str) -> io::Result<Vec<u8>>;
}

/// Files on disk; relative paths start at the folder of the case.
#[derive(Debug, Clone)]
pub struct Disk {
    folder: PathBuf,
}

impl Disk {
    /// Files relative to `folder`.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into() }
    }

    /// Files in the folder of the case at `path`.
    pub fn beside(path: &Path) -> Self {
        Self::new(path.parent().unwrap_or(Path::new("")))
    }
}

impl Files for Disk {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        read_bounded(&self.folder.join(path))
    }
}

/// Larger than any survey or case; a file of this size was named by mistake.
const LARGEST_FILE_BYTES: u64 = 64 << 20;

/// Reads a case, a study, a survey or another user file, of at most 64 MB.
///
/// # Errors
/// Errors of the system, and a sentence for anything but a regular file or for a larger one.
pub fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    read_bounded(path)
}

/// Reads a regular file of limited size. A device or pipe could block or never end.
fn read_bounded(path: &Path) -> io::Result<Vec<u8>> {
    let about = std::fs::metadata(path)?;
    if about.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder, not a file"));
    }
    if !about.is_file() {
        return Err(io::Error::other("it is not a regular file"));
    }
    if about.len() > LARGEST_FILE_BYTES {
        return Err(io::Error::new(
            io::ErrorKind::FileTooLarge,
            format!("it holds {} MB, more than 64 MB", about.len() >> 20),
        ));
    }
    std::fs::read(path)
}

/// Reads a pipe to its end.
///
/// # Errors
/// Errors of the system, and a sentence for more than 64 MB.
pub fn read_pipe(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    std::fs::File::open(path)?.take(LARGEST_FILE_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LARGEST_FILE_BYTES {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, "it holds more than 64 MB"));
    }
    Ok(bytes)
}

/// Files in memory, by name.
#[derive(Debug, Clone, Default)]
pub struct InMemory(pub std::collections::BTreeMap<String, Vec<u8>>);

impl Files for InMemory {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        let found = self.0.get(path).cloned();
        found.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "there is no such file"))
    }
}
