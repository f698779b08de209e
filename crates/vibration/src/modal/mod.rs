//! Small motions about the string at rest: natural frequencies and shapes, critical speeds, the
//! answer to a force that goes with the rotation.
//!
//! The string at rest is the [stiff string](wholestring::statics::stiff)'s, the inertia the
//! [dynamics](wholestring::dynamics)'. Theory: `docs/src/theory/modes.md`.

mod assembly;
mod campbell;
mod chain;
mod factors;
mod family;
mod krylov;
mod line;
mod mode;
mod motions;
mod pull;
mod response;
mod search;
mod whirl;

pub use assembly::{Assembly, assembly_length_m};
pub use campbell::{Branch, Campbell, Critical};
pub use family::Family;
pub use mode::{Mode, Place, Whirl};
pub use motions::SmallMotions;
pub use response::{Answer, Forcing};

use wholestring::statics::stiff::StiffError;

// Why there are no modes.

/// Why there are no modes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModalError {
    /// The string has no state at rest.
    #[error(transparent)]
    Stiff(#[from] StiffError),
    /// Modes were left out.
    #[error(
        "{count} lateral modes from {from_Hz} Hz on were not all found: request fewer of them, by \
        `modes.count`"
    )]
    Incomplete {
        /// Requested number of modes.
        count: usize,
        /// From this frequency on, Hz.
        from_Hz: f64,
    },
    /// A family's mode was not found.
    #[error(
        "of {count} {family} modes {found} were found, and the next one was not: set `modes.count` \
        to {} at most",
        (*found).max(1)
    )]
    Lost {
        /// Name of the family.
        family: &'static str,
        /// Requested number of modes.
        count: usize,
        /// Modes that were found.
        found: usize,
    },
}
