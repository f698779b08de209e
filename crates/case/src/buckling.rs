//! `[buckling]`.

use wholestring::statics::{buckling::Criterion, soft::SoftSettings};
use wholestring_config::prelude::*;

/// The criteria by name.
pub(crate) const CRITERIA: &[(&str, Criterion)] = &[
    ("he-kyllingstad", Criterion::HeKyllingstad),
    ("chen-lin-cheatham", Criterion::ChenLinCheatham),
    ("wu-juvkam-wold", Criterion::WuJuvkamWold),
];

/// Whether the soft string counts the side force of a helix.
pub(crate) const HELIX_SIDE_FORCE: &[(&str, bool)] = &[("left-out", false), ("counted", true)];

table! {
    /// Buckling criterion of a compressed string, and the effect of buckling on the soft string.
    BucklingTable in "[buckling]" {
        /// Critical loads that a compression is compared with, in columns, findings and lock-up:
        /// "he-kyllingstad" (Dawson and Paslay's sinusoid, `2 √(EI w/r)`, and Chen, Lin and
        /// Cheatham's helix, `2 √2 √(EI w/r)`, with the wall force from the hole's curvature
        /// included), "chen-lin-cheatham" (the same as in a straight hole) or "wu-juvkam-wold" (as
        /// in a straight hole, with the load of the fully developed helix, `2 (2 √2 − 1) √(EI
        /// w/r)`).
        criterion: Criterion = default(
            Choice { noun: "a buckling criterion", words: CRITERIA },
            Criterion::default(),
        );
        /// Soft string: whether a helix adds a wall force of `r F²/(4 EI)` and the drag from it:
        /// "left-out" or "counted". The forces of the other models always include it.
        helix_side_force: bool = default(
            Choice { noun: "a word for the side force of a helix", words: HELIX_SIDE_FORCE },
            SoftSettings::default().helix_side_force,
        );
    }
}

impl BucklingTable {
    /// Settings of the soft string.
    pub(crate) fn soft(&self) -> Option<SoftSettings> {
        let helix_side_force = *self.helix_side_force.get()?;
        Some(SoftSettings { helix_side_force, ..SoftSettings::default() })
    }
}
