//! Detournay and Defourny's law.

use wholestring::dynamics::{BitLaw, DetournayDefournyLaw};
use wholestring_config::prelude::*;

use super::law_keys::{CuttersKeys, FrontKeys, LawKeys};
use crate::bit::given::Around;

/// Defaults.
const FULL_CONTACT_M: f64 = 0.3e-3;

keys! {
    /// Detournay and Defourny's law.
    DetournayDefournyKeys {
        ..cutters: CuttersKeys;
        /// Depth of cut per revolution from which the wear flats are in full contact. Raising it
        /// raises the depth of cut under a light weight.
        full_contact_depth: f64 = default(
            Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1).usual(1e-5, 0.02), "0.3 mm"),
            FULL_CONTACT_M,
        );
        /// Largest depth of cut per revolution that the mud keeps clean; weight above that causes
        /// rubbing without cutting. Raising it lets the bit drill faster. Default: none.
        cleaning_limit: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::positive_to(0.1).usual(1e-4, 0.03),
            "8 mm",
        ));
        ..front: FrontKeys;
    }
}

impl Variant for DetournayDefournyKeys {
    const WORD: &'static str = "detournay-defourny";
    const MEANING: &'static str =
        "weight and torque from the depth of cut of a revolution, in three regimes";
}

impl LawKeys for DetournayDefournyKeys {
    fn build(&self, _place: Span, around: &Around<'_>, reader: &mut Reader) -> Option<BitLaw> {
        let (rock_stiffness_N_per_m, excitation) = self.front.build(None, reader)?;
        Some(BitLaw::DetournayDefourny(DetournayDefournyLaw {
            cutters: self.cutters.build(around.radius_m?, reader)?,
            full_contact_depth_m: *self.full_contact_depth.get()?,
            cleaning_limit_m: self.cleaning_limit_m(reader)?,
            rock_stiffness_N_per_m,
            excitation,
        }))
    }

    fn finds_rate(&self) -> Option<&'static str> {
        Some("Detournay and Defourny's law of the bit finds its own")
    }

    fn warn_of_weight(&self, law: &BitLaw, wob: &Spanned<f64>, reader: &mut Reader) {
        let BitLaw::DetournayDefourny(law) = law else { return };
        let most_N = law.cleaning_limit_m.map(|limit| law.weight_on_bit_N(limit));
        if let Some(most_N) = most_N.filter(|most| wob.value > *most) {
            reader.report(
                Diagnostic::warning("the bit is choked: not all weight cuts")
                    .at(
                        wob.place,
                        format!("{} drill as fast", reader.shown(Dimension::Force, most_N)),
                    )
                    .help("lower wob, or raise cleaning_limit under [bit]"),
            );
        }
    }
}

impl DetournayDefournyKeys {
    fn cleaning_limit_m(&self, reader: &mut Reader) -> Option<Option<f64>> {
        let Some(limit) = self.cleaning_limit.optional()? else {
            return Some(None);
        };
        let full = self.full_contact_depth.at()?;
        if limit.value <= full.value {
            let mut diagnostic =
                Diagnostic::error("the bit is choked before its wear flats are in contact").at(
                    limit.place,
                    format!("expected more than {}", reader.shown(Dimension::Diameter, full.value)),
                );
            if let Some(full) = self.full_contact_depth.given() {
                diagnostic = diagnostic.at(full.place, "full contact");
            }
            reader.report(diagnostic);
            return None;
        }
        Some(Some(limit.value))
    }
}
