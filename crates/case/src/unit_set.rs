//! Sets of units by name.

use wholestring_config::rule::Choice;
use wholestring_units::UnitSet;

/// A set of units by name.
pub const UNIT_SETS: Choice<UnitSet> = Choice {
    noun: "a unit set",
    words: &[("si", UnitSet::Si), ("metric", UnitSet::Metric), ("field", UnitSet::Field)],
};
