//! Information from the caller on a file.

use wholestring_units::Unit;

use crate::columns::column::Column;

/// Information on a survey in addition to its file.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Said {
    /// Unit of the lengths for which the file gives none.
    pub length_unit: Option<&'static Unit>,
    /// Unit of true vertical depth, north and east without one, if it differs from that of the
    /// lengths.
    pub position_unit: Option<&'static Unit>,
}

impl Said {
    /// Unit of a length that has none in the file.
    pub(crate) fn length_unit_of(&self, column: Column) -> Option<&'static Unit> {
        let is_position =
            matches!(column, Column::TrueVerticalDepth | Column::North | Column::East);
        self.position_unit.filter(|_| is_position).or(self.length_unit)
    }
}
