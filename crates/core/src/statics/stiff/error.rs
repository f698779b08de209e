//! Why there is no stiff string.

use crate::statics::soft::SoftError;

/// Why there is no stiff string.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StiffError {
    /// The soft string, which it begins with, has no answer.
    #[error(transparent)]
    Soft(#[from] SoftError),
    /// A string that slides down and is pressed against its wall the harder the harder it is pushed.
    #[error(
        "no equilibrium was found: by the wall load of its helix the string locks up at MD \
         {md_m:.0} m, and no push brings the weight to the bit"
    )]
    LocksUp {
        /// Measured depth where the compression grows beyond all bounds, m.
        md_m: f64,
    },
    /// There is an equilibrium with less friction, which ceases to be one before all of it is there.
    #[error(
        "no equilibrium was found: followed from no friction at all it is lost at {:.0} % of it, \
         after {iterations} iterations. The buckled string snaps into another shape there, or \
         rolls on for ever", 100.0 * part
    )]
    Lost {
        /// Part of the friction up to which there is one.
        part: f64,
        /// Newton steps of all stages.
        iterations: usize,
    },
    /// The iterations came to no end.
    #[error(
        "no equilibrium was found: at MD {md_m:.1} m forces are out of balance by {residual_N:.3e} N \
         after {iterations} iterations"
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
