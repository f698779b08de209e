//! `[rock]`: the solid rock, and what drills it.

mod bricks;
mod drilling;
mod limits;
mod material;
mod table;

pub(crate) use self::{drilling::drilling, table::RockTable};
