//! Arguments that several commands share.

mod batch;
mod case;
mod checkpoint;
mod kept;
mod operation;
mod output;
mod page;

pub(crate) use batch::BatchArgs;
pub(crate) use case::CaseArgs;
pub(crate) use checkpoint::CheckpointArgs;
pub(crate) use kept::KeptArgs;
pub(crate) use operation::operation;
pub(crate) use output::{OutputArgs, existing};
pub(crate) use page::PageArgs;
