//! `[rock]`: the solid rock, and what drills it.

mod bricks;
mod drilling;
mod limits;
mod material;
mod record;
mod table;

pub(crate) use self::{drilling::drilling, record::settings, table::RockTable};
