//! `[rock]`: the solid rock, and the bit in it.

mod drilling;
mod elements;
mod material;
mod table;

pub(crate) use self::{drilling::drilling, table::RockTable};
