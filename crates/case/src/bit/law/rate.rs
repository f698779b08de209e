//! The rate law.

use wholestring::dynamics::{BitLaw, RateLaw};
use wholestring_config::prelude::*;

use super::law_keys::{FrontKeys, LawKeys};
use crate::bit::given::Around;

keys! {
    /// The rate law.
    RateKeys {
        /// Torque of the bit at the operation's weight on bit. Where an operation drills or slides
        /// and the torque is missing, the bit turns without torque, with a warning.
        torque: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::from_to(0.0, 1e6).usual(50.0, 1e5),
            "3.1 kN.m",
        ));
        ..front: FrontKeys;
    }
}

impl Variant for RateKeys {
    const WORD: &'static str = "rate";
    const MEANING: &'static str = "the operation's rate of penetration in proportion to weight \
        and speed, torque in proportion to weight";
}

impl LawKeys for RateKeys {
    fn build(&self, _place: Span, _around: &Around<'_>, reader: &mut Reader) -> Option<BitLaw> {
        let (rock_stiffness_N_per_m, excitation) = self.front.build(None, reader)?;
        Some(BitLaw::Rate(RateLaw { rock_stiffness_N_per_m, excitation }))
    }

    fn finds_rate(&self) -> Option<&'static str> {
        None
    }

    fn torque_N_m(&self) -> Option<Option<f64>> {
        Some(self.torque.optional()?.map(|at| at.value))
    }
}
