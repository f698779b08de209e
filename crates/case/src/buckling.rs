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
    /// When a compressed string counts as buckled, and what that does to the soft string.
    BucklingTable in "[buckling]" {
        /// Whose loads a compression is compared with, in columns, findings and lock-up:
        /// "he-kyllingstad" (Dawson and Paslay's sinusoid, `2 √(EI w/r)`, and Chen, Lin and
        /// Cheatham's helix, `2 √2 √(EI w/r)`, with what the hole's curvature presses to the wall),
        /// "chen-lin-cheatham" (the same as in a straight hole) or "wu-juvkam-wold" (as in a
        /// straight hole, the helix where it is finished, `2 (2 √2 − 1) √(EI w/r)`).
        criterion: Criterion = default(
            Choice { noun: "a buckling criterion", words: CRITERIA },
            Criterion::default(),
        );
        /// Soft string: whether a helix presses itself to the wall by `r F²/(4 EI)` more, and drags
        /// so much more: "left-out" or "counted". The other models have it in their forces.
        helix_side_force: bool = default(
            Choice { noun: "a word for the side force of a helix", words: HELIX_SIDE_FORCE },
            SoftSettings::default().helix_side_force,
        );
    }
}

impl BucklingTable {
    /// What the soft string is told.
    pub(crate) fn soft(&self) -> Option<SoftSettings> {
        let helix_side_force = *self.helix_side_force.get()?;
        Some(SoftSettings { helix_side_force, ..SoftSettings::default() })
    }
}
