//! Writing a run to a checkpoint and resuming it.

mod difference;
mod keeper;
mod run_checkpoint;

pub(crate) use difference::{difference, is_of, other_arithmetic};
pub(crate) use keeper::Keeper;
pub(crate) use run_checkpoint::{RunCheckpoint, UnderWay};
