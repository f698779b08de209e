//! Why there are no modes.

use crate::statics::stiff::StiffError;

/// Why there are no modes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModalError {
    /// The string has no state at rest.
    #[error(transparent)]
    Stiff(#[from] StiffError),
    /// Modes were left out.
    #[error(
        "{wanted} modes from {from_Hz} Hz on were not all found: ask for fewer, or from another \
        frequency on"
    )]
    Incomplete {
        /// So many were wanted.
        wanted: usize,
        /// From this frequency on, Hz.
        from_Hz: f64,
    },
    /// A family's mode was not found.
    #[error("a {0} mode was not found among the others: ask for fewer")]
    Lost(&'static str),
}
