//! Laying a run aside and taking it up again.

mod difference;
mod keeper;
mod laid;

pub(crate) use difference::{difference, is_of, other_processor};
pub(crate) use keeper::Keeper;
pub(crate) use laid::{Laid, UnderWay};
