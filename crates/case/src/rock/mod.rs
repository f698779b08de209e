//! `[rock]`: the solid rock, and what drills it.

mod drilling;
mod elements;
mod limits;
mod material;
mod table;

pub(crate) use self::{drilling::drilling, table::RockTable};
