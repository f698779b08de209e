//! Why there are no modes.

use wholestring::statics::stiff::StiffError;

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
