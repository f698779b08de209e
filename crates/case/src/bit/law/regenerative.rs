//! The regenerative law.

use wholestring::dynamics::{BitLaw, RegenerativeLaw};
use wholestring_config::prelude::*;

use super::law_keys::{CuttersKeys, LawKeys};
use crate::bit::{given::Around, kind::Kind};

/// Default: the bit of Richard, Germay and Detournay's examples.
const BLADES: u64 = 4;

keys! {
    /// The regenerative law.
    RegenerativeKeys {
        /// Number of blades. Raising it stiffens the rock and shortens the delay.
        blades: u64 = default(Count { from: 1, to: 50 }, BLADES);
        ..cutters: CuttersKeys;
    }
}

impl Variant for RegenerativeKeys {
    const WORD: &'static str = "regenerative";
    const MEANING: &'static str = "Richard, Germay and Detournay: weight and torque from the depth \
        of cut that the blade before has left, which sticks, slips and bounces by itself";
}

impl LawKeys for RegenerativeKeys {
    fn build(&self, _place: Span, around: &Around<'_>, reader: &mut Reader) -> Option<BitLaw> {
        let radius_m = around.radius_m?;
        let kind = self.cutters.kind.kind.at()?;
        if kind.value == Kind::RollerCone {
            return Diagnostic::error(
                "the regenerative law is that of blades, which a roller cone has not",
            )
            .at(kind.place, "expected \"pdc\" or \"core\"")
            .help("law = \"detournay-defourny\" supports a roller cone")
            .refuse(reader);
        }
        Some(BitLaw::Regenerative(RegenerativeLaw {
            cutters: self.cutters.build(radius_m, reader)?,
            blades: u32::try_from(*self.blades.get()?).ok()?,
        }))
    }

    fn finds_rate(&self) -> Option<&'static str> {
        Some("the regenerative law of the bit finds its own")
    }

    fn warn_of_weight(&self, law: &BitLaw, wob: &Spanned<f64>, reader: &mut Reader) {
        let BitLaw::Regenerative(law) = law else { return };
        let bearing_N = law.cutters.wear_flat_weight_N();
        if wob.value <= bearing_N {
            reader.report(
                Diagnostic::warning("the wear flats carry all weight: the bit does not cut")
                    .at(
                        wob.place,
                        format!("they carry {}", reader.shown(Dimension::Force, bearing_N)),
                    )
                    .help("raise wob, or lower wear_flat or contact_strength under [bit]"),
            );
        }
    }
}
