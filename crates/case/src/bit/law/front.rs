//! The rock front of the laws that know no more of the bottom than its depth.

use wholestring::dynamics::{BitTable as Points, Excitation};
use wholestring_config::prelude::*;

use crate::bit::excitation::ExcitationTable;

/// Where the case does not say.
const ROCK_STIFFNESS_N_PER_M: f64 = 1e8;

keys! {
    /// A rock front.
    FrontKeys {
        /// Stiffness of the contact between bit and rock front. Raising it makes the weight on bit
        /// answer harder to axial motion. Only the dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12).usual(1e6, 1e11), "1e8 N/m"),
            ROCK_STIFFNESS_N_PER_M,
        );
        /// What shakes the bit.
        excitation: ExcitationTable = optional(Section::<ExcitationTable>::RULE);
    }
}

impl FrontKeys {
    /// Stiffness, N/m, and what shakes the bit; a table that the bit has may know its spread.
    pub(crate) fn build(
        &self,
        points: Option<&Points>,
        reader: &mut Reader,
    ) -> Option<(f64, Option<Excitation>)> {
        let excitation = self.excitation.get()?.build(points, reader)?;
        Some((*self.rock_stiffness.get()?, excitation))
    }
}
