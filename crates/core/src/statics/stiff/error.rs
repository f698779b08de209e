//! Why there is no stiff string.

use crate::statics::soft::SoftError;

/// Why there is no stiff string.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StiffError {
    /// The soft string, which it begins with, has no answer.
    #[error(transparent)]
    Soft(#[from] SoftError),
    /// The iterations came to no end.
    #[error(
        "no equilibrium was found: at MD {md_m:.1} m forces are out of balance by {residual_N:.3e} N \
         after {iterations} iterations. Where a buckled string slides down its hole there may be none: \
         it locks up, or snaps from one shape to another"
    )]
    NotConverged {
        /// Measured depth of the largest force out of balance, m.
        md_m: f64,
        /// That force, N.
        residual_N: f64,
        /// Newton steps of all stages.
        iterations: usize,
    },
}
