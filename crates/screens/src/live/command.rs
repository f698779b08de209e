//! What is asked of a live string and answered, one after the other.

use tokio::sync::oneshot;

/// Why a live string does not do what it was asked to.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LiveError {
    /// There is no such thing.
    #[error("there is no such {0}")]
    Nothing(&'static str),
    /// It cannot be so.
    #[error("{0}")]
    Refused(String),
    /// It has ended.
    #[error("{0}")]
    Ended(String),
    /// There are too many.
    #[error("{0}")]
    TooMany(String),
    /// It should have gone, and did not.
    #[error("{0}")]
    Failed(String),
}

/// Where the answer goes.
pub(super) type Reply<T> = oneshot::Sender<Result<T, LiveError>>;

/// What is asked.
#[derive(Debug)]
pub(super) enum Command {
    /// Go back to a checkpoint; with `replay`, do again what was done after it.
    Rewind { number: u64, replay: bool, reply: Reply<()> },
    /// Make a checkpoint now; its number.
    Checkpoint { reply: Reply<u64> },
}
