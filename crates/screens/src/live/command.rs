//! Commands to a live string that have a response, handled in order.

use tokio::sync::oneshot;
use wholestring_judge::Wording;
use wholestring_units::UnitSet;

/// Reason why a live string refuses a request.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LiveError {
    /// The object does not exist.
    #[error("there is no such {0}")]
    Nothing(&'static str),
    /// The request is invalid; quantities of the sentence may be marked.
    #[error("{}", Wording::from(.0.as_str()).in_units(UnitSet::Si))]
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

impl LiveError {
    /// The reason in these units.
    pub fn in_units(&self, units: UnitSet) -> String {
        match self {
            Self::Refused(sentence) => Wording::from(sentence.as_str()).in_units(units),
            error => error.to_string(),
        }
    }
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
