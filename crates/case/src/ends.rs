//! `[ends]`.

use wholestring::ends::{BitEnd, Ends, TopEnd};
use wholestring_config::prelude::*;

use crate::bit::BitTable;

/// How the top is held.
pub(crate) const TOPS: &[(&str, TopEnd)] =
    &[("clamped", TopEnd::Clamped), ("pinned", TopEnd::Pinned)];

/// How the bit is held.
pub(crate) const BITS: &[(&str, BitEnd)] = &[
    ("held", BitEnd::Held),
    ("pinned", BitEnd::Pinned),
    ("clamped", BitEnd::Clamped),
    ("free", BitEnd::Free),
];

table! {
    /// How the ends of the string are held across the hole. The soft string does not use it.
    EndsTable in "[ends]" {
        /// The top, which never leaves the hole's axis: "clamped" (along the axis, as in the rotary
        /// table) or "pinned" (free to tilt).
        top: TopEnd = default(Choice { noun: "a way to hold the top", words: TOPS }, TopEnd::default());
        /// The bit: "held" (by `lateral_stiffness` of `[bit]`, free to tilt), "pinned" (on the
        /// hole's axis exactly, free to tilt), "clamped" (on the axis and along it) or "free" (it
        /// touches the wall and rubs like the string above it).
        bit: BitEnd = default(Choice { noun: "a way to hold the bit", words: BITS }, BitEnd::default());
    }
}

impl EndsTable {
    pub(crate) fn build(&self, bit: Option<&BitTable>, reader: &mut Reader) -> Option<Ends> {
        let ends = Ends { top: *self.top.get()?, bit: *self.bit.get()? };
        let stiffness = bit.and_then(|bit| bit.lateral_stiffness.given());
        if let (Some(given), true) = (stiffness, ends.bit != BitEnd::Held) {
            Diagnostic::idle("lateral_stiffness", given.place, "used with bit = \"held\"")
                .chosen("the bit's end", self.bit.place(), "held")
                .report(reader);
        }
        Some(ends)
    }
}
