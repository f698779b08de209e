//! Errors of the folder.

use std::{io, path::PathBuf};

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
        why: &'static str,
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
