//! Components of a string in a table.

mod cell;
mod header;
mod imported;
mod layout;
mod rows;

pub(crate) use header::{Found, find};
pub use imported::{Holds, ImportedTally, TallyCell, TallyRow, TallyTotal};
pub(crate) use rows::read;
