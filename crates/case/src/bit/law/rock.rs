//! Solid rock that the bit's face breaks.

use wholestring::{
    dynamics::{BitLaw, RockLaw},
    rock::BitShape,
};
use wholestring_config::prelude::*;

use super::law_keys::LawKeys;
use crate::bit::{
    face::FaceTable,
    given::Around,
    kind::{Kind, KindKeys},
};

keys! {
    /// Solid rock. A bit test uses these keys with any law.
    RockKeys {
        ..kind: KindKeys;
        /// The shape of the bit; a bit test uses it with any law.
        face: FaceTable = optional(Section::<FaceTable>::RULE);
    }
}

impl Variant for RockKeys {
    const WORD: &'static str = "rock";
    const MEANING: &'static str = "the bit's face breaks the solid rock of `[rock]`";
}

impl LawKeys for RockKeys {
    fn build(&self, _place: Span, around: &Around<'_>, _reader: &mut Reader) -> Option<BitLaw> {
        Some(BitLaw::Rock(Box::new(RockLaw { drilling: around.drilling?.clone() })))
    }

    fn finds_rate(&self) -> Option<&'static str> {
        Some("the rock under the bit has its own")
    }
}

impl RockKeys {
    /// Returns the numbers of the bit's face, `radius_m` wide at the gauge.
    pub(crate) fn shape(&self, radius_m: f64, reader: &mut Reader) -> Option<BitShape> {
        let kind = self.kind.kind.at()?;
        if kind.value == Kind::RollerCone {
            return Diagnostic::error("against solid rock, cones that roll are not modelled")
                .at(kind.place, "expected \"pdc\", \"core\" or \"inserts\"")
                .help(
                    "\"inserts\" has fixed teeth: these crush and scrape, and their torque is not \
                     that of rolling ones",
                )
                .help("the laws \"detournay-defourny\" and \"table\" support a roller cone")
                .refuse(reader);
        }
        let core_radius_m = self.kind.core_radius_m(radius_m, reader)?;
        let face = self.face.get()?;
        face.shape(kind.value, 2.0 * radius_m, 2.0 * core_radius_m, reader)
    }
}
