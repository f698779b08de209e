//! Why there is no stiff string.

use crate::statics::soft::SoftError;

/// Why there is no stiff string.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StiffError {
    /// The soft string, which it begins with, has no answer.
    #[error(transparent)]
    Soft(#[from] SoftError),
    /// A string that slides down and is pressed against its wall the harder the harder it is
    /// pushed.
    #[error(
        "no equilibrium was found: by the wall load of its helix the string locks up at MD \
         {md_m:.0} m, and no push brings the weight to the bit"
    )]
    LocksUp {
        /// Measured depth where the compression grows beyond all bounds, m.
        md_m: f64,
    },
    /// Its compression grows beyond all bounds, though the wall load of a helix by itself would let
    /// it through.
    #[error(
        "no equilibrium was found: the compression grows beyond all bounds, {compression_N:.3e} N at \
         MD {md_m:.0} m after {iterations} iterations: the string locks up"
    )]
    RunsAway {
        /// Measured depth of the largest compression, m.
        md_m: f64,
        /// That compression, N.
        compression_N: f64,
        /// Newton steps of all stages.
        iterations: usize,
    },
    /// A string that turns, is buckled, and goes round its hole by its friction without an end.
    #[error(
        "no equilibrium was found: about MD {md_m:.0} m the buckled string rolls around its hole, by \
         the friction of its rotation, and went on for {iterations} iterations. It may have no \
         state of rest: the dynamics show how it whirls"
    )]
    Rolls {
        /// Measured depth where it went round farthest, m.
        md_m: f64,
        /// Newton steps of all stages.
        iterations: usize,
    },
    /// An element of a length that was given is too long for the compression that it came to bear:
    /// it buckles between its nodes, where no wall holds it.
    #[error(
        "no equilibrium was found: at MD {md_m:.0} m the compression came to {compression_N:.3e} N, \
         under which an element of {length_m:.1} m buckles between its nodes; shorter elements are \
         needed"
    )]
    ElementBuckles {
        /// Measured depth of the element, m.
        md_m: f64,
        /// The compression on it, N.
        compression_N: f64,
        /// Its length, m.
        length_m: f64,
    },
    /// The wall gives way farther than its contact law holds.
    #[error(
        "at MD {md_m:.0} m the string is pressed {penetration_m:.3} m into the wall, farther than its \
        mean clearance of {clearance_m:.3} m: no wall that the contact law describes is so soft. \
        Give a larger `contact_stiffness`, or the contact law \"hertz\""
    )]
    ThroughWall {
        /// Measured depth of the deepest penetration, m.
        md_m: f64,
        /// That penetration, m.
        penetration_m: f64,
        /// Mean clearance of the string, m.
        clearance_m: f64,
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
