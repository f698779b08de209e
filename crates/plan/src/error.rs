//! Why there is no plan.

use wholestring::well::HoleError;

use crate::wear::CasingError;

/// Why there is no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// Frictions make no hole.
    #[error(transparent)]
    Hole(#[from] HoleError),
    /// A casing cannot be worn.
    #[error(transparent)]
    Casing(#[from] CasingError),
}
