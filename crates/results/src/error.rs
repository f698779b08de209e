//! Why results could not be written or read back.

use std::{
    io,
    path::{Path, PathBuf},
};

/// Why results could not be written or read back; always with the file or folder it is about.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// The folder for the results could not be made: no permission, or a file has its name.
    #[error("cannot make the folder {}: {}", path.display(), reason(source))]
    Folder {
        /// The folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file could not be written: no permission, disk full, or a folder has its name.
    #[error("cannot write {}: {}", path.display(), reason(source))]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file could not be read.
    #[error("cannot read {}: {}", path.display(), reason(source))]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file was read but does not hold what it should.
    #[error("{} is not a file of results: {reason}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A checkpoint that no run can continue from.
    #[error("{} is no checkpoint that can be resumed: {reason}", path.display())]
    Checkpoint {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
}

impl ResultsError {
    pub(crate) fn format(path: &Path, reason: impl ToString) -> Self {
        Self::Format { path: path.to_owned(), reason: reason.to_string() }
    }
}

/// The system's reason in the user's words, with the way out where there is one.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::StorageFull => "the disk is full".into(),
        io::ErrorKind::PermissionDenied => {
            "permission denied (is it open in another program, or in a protected folder?)".into()
        }
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "a file stands where a folder is needed".into()
        }
        io::ErrorKind::IsADirectory => "a folder has that name".into(),
        io::ErrorKind::NotFound => "it does not exist".into(),
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only".into(),
        _ => error.to_string(),
    }
}
