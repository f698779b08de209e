//! Contents of a tally.

use wholestring_units::{Dimension, Unit};

use crate::columns::column::Column;

/// The components of a string as a table lists them.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedTally {
    /// Name of the sheet; `None` for a text.
    pub sheet: Option<String>,
    /// The rows of components, in the order of the table.
    pub rows: Vec<TallyRow>,
    /// The rows of sums.
    pub totals: Vec<TallyTotal>,
    /// Notes on its interpretation.
    pub notes: Vec<String>,
    /// Columns and rows that are not used, in words.
    pub left_out: Vec<String>,
}

/// A row of a tally: a component.
#[derive(Debug, Clone, PartialEq)]
pub struct TallyRow {
    /// Its place: `line 5`, `row 5 of sheet 'BHA'`.
    pub place: String,
    /// Its cells that are not empty.
    pub cells: Vec<TallyCell>,
}

impl TallyRow {
    /// The cell of a column, if it is not empty.
    pub fn get(&self, column: Column) -> Option<&TallyCell> {
        self.cells.iter().find(|cell| cell.column == column)
    }
}

/// A cell of a tally.
#[derive(Debug, Clone, PartialEq)]
pub struct TallyCell {
    /// Its column.
    pub column: Column,
    /// Its place: `line 5, column 'OD'`, `sheet 'BHA', cell C5`.
    pub place: String,
    /// The text as written.
    pub written: String,
    /// Its value.
    pub holds: Holds,
}

/// Value of a cell of a tally.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Holds {
    /// A quantity in the unit of the file.
    Quantity {
        /// The number.
        number: f64,
        /// Its unit.
        unit: &'static Unit,
        /// Dimension of the unit: a weight per length may be a force.
        dimension: Dimension,
    },
    /// A count.
    Count(f64),
    /// Words, as written.
    Words,
    /// The component fills the string to the surface.
    ToSurface,
}

impl TallyCell {
    /// The quantity in SI; `None` for words and counts.
    pub fn si(&self) -> Option<f64> {
        match self.holds {
            Holds::Quantity { number, unit, .. } => Some(unit.to_si(number)),
            _ => None,
        }
    }

    /// The count; `None` for other values.
    pub fn count(&self) -> Option<f64> {
        match self.holds {
            Holds::Count(count) => Some(count),
            _ => None,
        }
    }
}

/// A row of sums.
#[derive(Debug, Clone, PartialEq)]
pub struct TallyTotal {
    /// Number of rows with components above it.
    pub rows_above: usize,
    /// The length that it states.
    pub length: TallyCell,
}
