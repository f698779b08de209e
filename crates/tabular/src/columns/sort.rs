//! The sorts of tables that are read.

use crate::columns::column::Column;

/// A sort of table: its possible columns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sort {
    /// Every column, the required ones first.
    pub(crate) columns: &'static [Column],
    /// The required columns.
    pub(crate) needed: &'static [Column],
}

/// Stations of a path.
pub(crate) const SURVEY: Sort = Sort { columns: &Column::ALL, needed: &Column::NEEDED };

/// Weights and torques that were read at the surface.
pub(crate) const READINGS: Sort = Sort { columns: &Column::READINGS, needed: &[Column::BitDepth] };

/// The components of a string.
pub(crate) const TALLY: Sort = Sort {
    columns: &Column::TALLY,
    needed: &[Column::Component, Column::OutsideDiameter, Column::Length],
};
