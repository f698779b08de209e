//! Why there is no map.

use crate::{dynamics::SetupError, statics::soft::SoftError};

/// Why small motions about steady rotation cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StabilityError {
    /// The string does not turn on bottom.
    #[error("torsional stability is that of a string that drills and turns: kind = \"drill\"")]
    NotDrilling,
    /// A bit on solid rock.
    #[error(
        "a bit on solid rock has no law whose slopes are known: measure it with a bit test, and \
         give its table to the bit"
    )]
    SolidRock,
    /// The bit does not turn.
    #[error("the bit does not turn: its motor stalls, or the string does not turn")]
    Stands,
    /// A controller or a friction law of the caller's own.
    #[error("{0} of one's own has no slopes that are known")]
    Custom(&'static str),
    /// A range that holds nothing.
    #[error("{0} must be positive, the second above the first, in two steps at least")]
    Range(&'static str),
    /// Settings that no run can use.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The string cannot be laid in its hole.
    #[error(transparent)]
    Soft(#[from] SoftError),
}
