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

    /// It holds files that results would replace, and no record that they are results.
    #[error(
        "{} holds {}, which results would replace, and no record that they are results",
        path.display(),
        listed(names)
    )]
    Foreign {
        /// The folder.
        path: PathBuf,
        /// Names of the files.
        names: Vec<String>,
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

/// Number of names that are listed; further ones are counted.
const LISTED: usize = 4;

fn listed(names: &[String]) -> String {
    let shown = names.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(LISTED) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

fn whose(there: Option<&Occupant>, alike: bool) -> String {
    match there {
        Some(there) if alike => {
            format!("the {} \"{}\" with other settings or data", there.kind, there.name)
        }
        Some(there) => format!("the {} of another case, \"{}\"", there.kind, there.name),
        None => "results without a record of their case".to_owned(),
    }
}
