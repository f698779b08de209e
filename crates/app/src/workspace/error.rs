//! Why something of the folder cannot be had.

use std::{io, path::PathBuf};

/// Why something of the folder cannot be had.
#[derive(Debug, thiserror::Error)]
pub(crate) enum WorkspaceError {
    /// The folder itself cannot be used.
    #[error("the folder {} cannot be used: {why}", path.display())]
    Folder {
        /// As it was named.
        path: PathBuf,
        /// What the system says.
        why: String,
    },
    /// Nothing has this id.
    #[error("there is no such {0} in the folder")]
    Nothing(&'static str),
    /// No file may be called so.
    #[error("`{}` is no name for a file: {why}", name.escape_debug())]
    Name {
        /// What was given.
        name: String,
        /// What is wrong with it.
        why: &'static str,
    },
    /// A file is there that must not be written over.
    #[error("there is a file `{0}` already")]
    Exists(String),
    /// The file is not what it was when its text was read.
    #[error("the file has changed since it was opened")]
    Changed,
    /// The system refused.
    #[error("{what}: {source}")]
    System {
        /// What was tried: `the case cannot be read`.
        what: &'static str,
        /// What the system says.
        source: io::Error,
    },
}

impl WorkspaceError {
    /// What the system says of what was tried.
    pub(super) fn system(what: &'static str) -> impl Fn(io::Error) -> Self {
        move |source| Self::System { what, source }
    }
}
