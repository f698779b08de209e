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
    /// It would lead out of the folder.
    #[error("`{0}` lies outside the folder of the cases")]
    Outside(String),
    /// The system refused.
    #[error("{what}: {source}")]
    System {
        /// What was tried: `the case cannot be read`.
        what: &'static str,
        /// What the system says.
        source: io::Error,
    },
}
