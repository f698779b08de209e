//! `[ends]`.

use wholestring::ends::{BitEnd, Ends, TopEnd};
use wholestring_config::prelude::*;

use crate::bit::BitTable;

/// Supports of the top.
pub(crate) const TOPS: &[(&str, TopEnd)] =
    &[("clamped", TopEnd::Clamped), ("pinned", TopEnd::Pinned)];

/// Supports of the bit.
pub(crate) const BITS: &[(&str, BitEnd)] = &[
    ("held", BitEnd::Held),
    ("pinned", BitEnd::Pinned),
    ("clamped", BitEnd::Clamped),
    ("free", BitEnd::Free),
];

table! {
    /// Lateral supports of the ends of the string. The soft string does not use them.
    EndsTable in "[ends]" {
        /// The top, which never leaves the hole's axis: "clamped" (along the axis, as in the rotary
        /// table) or "pinned" (free to tilt).
        top: TopEnd = default(Choice { noun: "a way to hold the top", words: TOPS }, TopEnd::default());
        /// The bit: "held" (by `lateral_stiffness` of `[bit]`, free to tilt), "pinned" (exactly on
        /// the hole's axis, free to tilt), "clamped" (on the axis and along it) or "free" (it
        /// touches the wall with friction, like the string above it).
        bit: BitEnd = default(Choice { noun: "a way to hold the bit", words: BITS }, BitEnd::default());
    }
}

impl EndsTable {
    pub(crate) fn build(&self, bit: Option<&BitTable>, reader: &mut Reader) -> Option<Ends> {
        let ends = Ends { top: *self.top.get()?, bit: *self.bit.get()? };
        let stiffness = bit.and_then(|bit| bit.lateral_stiffness.given());
        if let (Some(entry), true) = (stiffness, ends.bit != BitEnd::Held) {
            Diagnostic::idle("lateral_stiffness", entry.place, "used with bit = \"held\"")
                .chosen("the bit's end", self.bit.place(), "held")
                .report(reader);
        }
        Some(ends)
    }
}
