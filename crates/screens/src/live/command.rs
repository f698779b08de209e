//! Commands to a live string that have a response, handled in order.

use tokio::sync::oneshot;

/// Reason why a live string refuses a request.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LiveError {
    /// The object does not exist.
    #[error("there is no such {0}")]
    Nothing(&'static str),
    /// The request is invalid.
    #[error("{0}")]
    Refused(String),
    /// It has ended.
    #[error("{0}")]
    Ended(String),
    /// The number is limited.
    #[error("{0}")]
    TooMany(String),
    /// An operation failed unexpectedly.
    #[error("{0}")]
    Failed(String),
}

/// Channel of the response.
pub(super) type Reply<T> = oneshot::Sender<Result<T, LiveError>>;

/// Commands.
#[derive(Debug)]
pub(super) enum Command {
    /// Rewinds to a checkpoint; with `replay`, the later events are applied again.
    Rewind { number: u64, replay: bool, reply: Reply<()> },
    /// Makes a checkpoint now, and returns its number.
    Checkpoint { reply: Reply<u64> },
}
