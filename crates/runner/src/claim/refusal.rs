//! Why results do not go to a folder.

use std::path::PathBuf;

use thiserror::Error;
use wholestring_results::Occupant;

/// A folder that results cannot go to.
#[derive(Debug, Clone, Error)]
pub enum FolderRefused {
    /// It holds other results.
    #[error("{} holds {}", path.display(), whose(there.as_ref(), *alike))]
    Occupied {
        /// The folder.
        path: PathBuf,
        /// What its results are of; nothing where they do not say.
        there: Option<Occupant>,
        /// Whether they are called as those that were to go there.
        alike: bool,
    },

    /// The same work was begun there and not finished.
    #[error("{} holds an unfinished {kind} of this case", path.display())]
    Unfinished {
        /// The folder.
        path: PathBuf,
        /// What was begun: `run`, `sweep`, `study`, `bit test`.
        kind: String,
    },

    /// Another program writes there.
    #[error("another run is writing to {}", path.display())]
    Busy {
        /// The folder.
        path: PathBuf,
    },

    /// Another program solves a share there that has cases of this one.
    #[error("another run is solving share {share} in {}", path.display())]
    ShareBusy {
        /// The folder.
        path: PathBuf,
        /// The other share: `2/4`.
        share: String,
    },

    /// The default folder and all that are called like it hold other results.
    #[error("{} and {count} folders like it hold other results", path.display())]
    AllOccupied {
        /// The default folder.
        path: PathBuf,
        /// How many there are.
        count: usize,
    },
}

fn whose(there: Option<&Occupant>, alike: bool) -> String {
    match there {
        Some(there) if alike => {
            format!("the {} \"{}\" with other settings or data", there.kind, there.name)
        }
        Some(there) => format!("the {} of another case, \"{}\"", there.kind, there.name),
        None => "results of an earlier version, which did not say of which case".to_owned(),
    }
}
