//! Settings of the stiff string.

use crate::{sizing::ElementLength, wall::contact::ContactLaw};

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
