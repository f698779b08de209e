//! Errors of writing results and reading them back.

use std::{
    io,
    path::{Path, PathBuf},
};

/// Error of writing results or reading them back; always with the file or folder that it concerns.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// The folder for the results could not be made: no permission, or a file has its name.
    #[error("cannot make the folder {}: {}", path.display(), reason(source))]
    Folder {
        /// The folder.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// A file could not be written: no permission, disk full, or a folder has its name.
    #[error("cannot write {}: {}", path.display(), reason(source))]
    Write {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// A file could not be read.
    #[error("cannot read {}: {}", path.display(), reason(source))]
    Read {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// A file was read but does not have the required content.
    #[error("{} is not a file of results: {reason}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// Defect of the file.
        reason: String,
    },
    /// A checkpoint from which no run can continue.
    #[error("{} is no checkpoint that can be resumed: {reason}", path.display())]
    Checkpoint {
        /// The file.
        path: PathBuf,
        /// Defect of the checkpoint.
        reason: String,
    },
}

impl ResultsError {
    pub(crate) fn format(path: &Path, reason: impl ToString) -> Self {
        Self::Format { path: path.to_owned(), reason: reason.to_string() }
    }

    /// Whether a file that was to be read is at fault; otherwise results cannot be written.
    pub fn is_of_reading(&self) -> bool {
        match self {
            Self::Read { .. } | Self::Format { .. } | Self::Checkpoint { .. } => true,
            Self::Folder { .. } | Self::Write { .. } => false,
        }
    }
}

/// The system's reason in the user's words, with a remedy where there is one.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::StorageFull => "the disk is full".into(),
        io::ErrorKind::PermissionDenied => {
            "permission denied (is it open in another program, or in a protected folder?)".into()
        }
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "a file has the name of the folder".into()
        }
        io::ErrorKind::IsADirectory => "a folder has that name".into(),
        io::ErrorKind::NotFound => "it does not exist".into(),
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only".into(),
        _ => error.to_string(),
    }
}
