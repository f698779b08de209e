//! Errors of a plan.

use wholestring::well::HoleError;

use crate::wear::CasingError;

/// The reason why there is no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// The friction factors are not valid for the hole.
    #[error(transparent)]
    Hole(#[from] HoleError),
    /// A casing cannot be worn.
    #[error(transparent)]
    Casing(#[from] CasingError),
}
