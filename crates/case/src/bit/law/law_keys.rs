//! The interface of the keys of a law.

use wholestring::{
    dynamics::{BitLaw, BitSettings},
    operation::Operation,
};

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned, source::Span};

use crate::bit::{around::Around, given::Given};

/// The keys of a law: the law that they give, and its effect on the operation's set points.
pub(crate) trait LawKeys {
    /// Builds the law; `place` is where it was chosen.
    fn build(&self, place: Span, around: &Around<'_>, reader: &mut Reader) -> Option<BitLaw>;

    /// The reason why `rop` has no effect, of a law that computes torque and rate of penetration
    /// from weight and speed; `None` where they are the operation's.
    fn finds_rate(&self) -> Option<&'static str>;

    /// Torque at the operation's weight on bit, N.m, of a law that does not compute it; the inner
    /// `None` follows a mistake.
    fn torque_N_m(&self) -> Option<Option<f64>> {
        Some(None)
    }

    /// Warns of a weight on bit of which the law uses little.
    fn warn_of_weight(&self, _law: &BitLaw, _wob: &Spanned<f64>, _reader: &mut Reader) {}

    /// Refuses an operation that the law does not support.
    fn check_operation(
        &self,
        _bit: &BitSettings,
        _operation: &Operation,
        _given: &Given<'_>,
        _reader: &mut Reader,
    ) -> Option<()> {
        Some(())
    }

    /// Warns of set points that the law does not use.
    fn warn_of_set_points(&self, law: &BitLaw, set_points: &Given<'_>, reader: &mut Reader) {
        if let Some((finds, rop)) = self.finds_rate().zip(set_points.rop) {
            reader.report(Diagnostic::idle("rop", rop.place, finds));
        }
        if let Some(wob) = set_points.wob {
            self.warn_of_weight(law, wob, reader);
        }
    }
}
