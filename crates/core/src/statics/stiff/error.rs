//! Errors of the stiff string, and its settings.

use crate::{sizing::ElementLength, statics::soft::SoftError, wall::contact::ContactLaw};

/// Error of the stiff string.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StiffError {
    /// The soft string, with which the stiff string begins, has no solution.
    #[error(transparent)]
    Soft(#[from] SoftError),
    /// A sliding string locks up: the harder it is pushed, the harder its helix presses on the
    /// wall.
    #[error(
        "no equilibrium was found: the string locks up at MD {md_m:.0} m by the wall force of its \
         helix, and no push brings the weight to the bit"
    )]
    LocksUp {
        /// Measured depth where the compression grows beyond all bounds, m.
        md_m: f64,
    },
    /// The compression grows beyond all bounds, though the push would pass the wall load of a helix
    /// alone.
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
    /// A rotating, buckled string that rolls around its hole by its friction without an end.
    #[error(
        "no equilibrium was found: about MD {md_m:.0} m the buckled string still rolls around its \
         hole, by the friction of its rotation, after {iterations} iterations. It may have no \
         static equilibrium: the dynamics compute its whirl"
    )]
    Rolls {
        /// Measured depth where it rolled farthest, m.
        md_m: f64,
        /// Newton steps of all stages.
        iterations: usize,
    },
    /// An element of a given length is too long for the compression on it: it buckles between its
    /// nodes, where no wall supports it.
    #[error(
        "no equilibrium was found: at MD {md_m:.0} m the compression reached {compression_N:.3e} \
         N, under which an element of {length_m:.1} m buckles between its nodes; shorter elements \
         are needed"
    )]
    ElementBuckles {
        /// Measured depth of the element, m.
        md_m: f64,
        /// The compression on it, N.
        compression_N: f64,
        /// Its length, m.
        length_m: f64,
    },
    /// The penetration of the wall exceeds the range of its contact law.
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
    /// The iterations did not converge.
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

// Settings of the stiff string.

/// Settings of the stiff string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StiffSettings {
    /// Length of the elements.
    pub element_length: ElementLength,
    /// Divisor of every element length: 1, and more for convergence studies.
    pub refinement: u32,
    /// Contact law of the wall.
    pub contact_law: ContactLaw,
    /// Lateral stiffness that holds the bit to the axis of its hole, N/m, where its end of the
    /// string is [held](crate::ends::BitEnd::Held).
    pub bit_lateral_stiffness_N_per_m: f64,
    /// Whether the weight between nodes acts on them by its forces alone, as in the dynamics, and
    /// not by its fixed-end moments, too: for comparisons of the two on the same elements.
    pub lumped_weight: bool,
}

impl Default for StiffSettings {
    fn default() -> Self {
        Self {
            element_length: ElementLength::default(),
            refinement: 1,
            contact_law: ContactLaw::Hertz { dissipation_s_per_m: 0.0 },
            bit_lateral_stiffness_N_per_m: 1e7,
            lumped_weight: false,
        }
    }
}
