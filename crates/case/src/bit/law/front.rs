//! The rock front of the laws whose only state of the bottom is its depth.

use wholestring::dynamics::{BitTable as Points, Excitation};
use wholestring_config::prelude::*;

use crate::bit::excitation::ExcitationTable;

/// Default.
const ROCK_STIFFNESS_N_PER_M: f64 = 1e8;

keys! {
    /// A rock front.
    FrontKeys {
        /// Stiffness of the contact between bit and rock front. Raising it raises the change of the
        /// weight on bit with axial motion. Only the dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12).usual(1e6, 1e11), "1e8 N/m"),
            ROCK_STIFFNESS_N_PER_M,
        );
        /// Excitation of the bit.
        excitation: ExcitationTable = optional(Section::<ExcitationTable>::RULE);
    }
}

impl FrontKeys {
    /// Returns stiffness, N/m, and excitation; a measured table of the bit may give the standard
    /// deviations of the excitation.
    pub(crate) fn build(
        &self,
        points: Option<&Points>,
        reader: &mut Reader,
    ) -> Option<(f64, Option<Excitation>)> {
        let excitation = self.excitation.get()?.build(points, reader)?;
        Some((*self.rock_stiffness.get()?, excitation))
    }
}
