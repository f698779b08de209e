//! What a tally gives.

use wholestring_units::{Dimension, Unit};

use crate::columns::column::Column;

/// The components of a string as a table lists them.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedTally {
    /// Name of the sheet; none of a text.
    pub sheet: Option<String>,
    /// The rows that hold a component, in the order of the table.
    pub rows: Vec<TallyRow>,
    /// The rows that add up others.
    pub totals: Vec<TallyTotal>,
    /// How it was understood, in sentences for people.
    pub notes: Vec<String>,
    /// Columns and rows that are not used, in words.
    pub left_out: Vec<String>,
}

/// A row of a tally: a component.
#[derive(Debug, Clone, PartialEq)]
pub struct TallyRow {
    /// Where it stands: `line 5`, `row 5 of sheet 'BHA'`.
    pub place: String,
    /// Its cells that hold anything.
    pub cells: Vec<TallyCell>,
}

impl TallyRow {
    /// The cell of a column, if it holds anything.
    pub fn get(&self, column: Column) -> Option<&TallyCell> {
        self.cells.iter().find(|cell| cell.column == column)
    }
}

/// A cell of a tally.
#[derive(Debug, Clone, PartialEq)]
pub struct TallyCell {
    /// What it is.
    pub column: Column,
    /// Where it stands: `line 5, column 'OD'`, `sheet 'BHA', cell C5`.
    pub place: String,
    /// As it is written.
    pub written: String,
    /// What it says.
    pub holds: Holds,
}

/// What a cell of a tally says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Holds {
    /// A quantity in the unit that it was found in.
    Quantity {
        /// The number.
        number: f64,
        /// Its unit.
        unit: &'static Unit,
        /// What the unit measures: a weight per length may be a force.
        dimension: Dimension,
    },
    /// A count.
    Count(f64),
    /// Words, as they are written.
    Words,
    /// The component fills the rest of the string.
    ToSurface,
}

impl TallyCell {
    /// The quantity in SI; none of words and counts.
    pub fn si(&self) -> Option<f64> {
        match self.holds {
            Holds::Quantity { number, unit, .. } => Some(unit.to_si(number)),
            _ => None,
        }
    }

    /// The count; none of others.
    pub fn count(&self) -> Option<f64> {
        match self.holds {
            Holds::Count(count) => Some(count),
            _ => None,
        }
    }
}

/// A row that adds up others.
#[derive(Debug, Clone, PartialEq)]
pub struct TallyTotal {
    /// How many rows with components stand above it.
    pub rows_above: usize,
    /// The length that it states.
    pub length: TallyCell,
}
