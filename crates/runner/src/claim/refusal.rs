//! Reasons why a folder is refused for results.

use std::path::PathBuf;

use thiserror::Error;
use wholestring_results::Occupant;

/// A folder that cannot take the results.
#[derive(Debug, Clone, Error)]
pub enum FolderRefused {
    /// It holds other results.
    #[error("{} holds {}", path.display(), whose(there.as_ref(), *alike))]
    Occupied {
        /// The folder.
        path: PathBuf,
        /// Owner of its results; `None` if they do not record it.
        there: Option<Occupant>,
        /// Whether they have the same kind and name as the new results.
        alike: bool,
    },

    /// The same work was begun there and not finished.
    #[error("{} holds an unfinished {kind} of this case", path.display())]
    Unfinished {
        /// The folder.
        path: PathBuf,
        /// Kind of work that was begun: `run`, `sweep`, `study`, `bit test`.
        kind: String,
    },

    /// Another program writes there.
    #[error("another run is writing to {}", path.display())]
    Busy {
        /// The folder.
        path: PathBuf,
    },

    /// Another program there solves a share that overlaps with this one.
    #[error("another run is solving share {share} in {}", path.display())]
    ShareBusy {
        /// The folder.
        path: PathBuf,
        /// The other share, such as `2/4`.
        share: String,
    },

    /// The default folder and all numbered folders of its name contain other results.
    #[error("{} and {count} folders like it hold other results", path.display())]
    AllOccupied {
        /// The default folder.
        path: PathBuf,
        /// Number of these folders.
        count: usize,
    },
}

fn whose(there: Option<&Occupant>, alike: bool) -> String {
    match there {
        Some(there) if alike => {
            format!("the {} \"{}\" with other settings or data", there.kind, there.name)
        }
        Some(there) => format!("the {} of another case, \"{}\"", there.kind, there.name),
        None => "results of an earlier version, which did not record their case".to_owned(),
    }
}
