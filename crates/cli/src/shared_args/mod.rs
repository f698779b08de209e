//! Arguments that several commands share.

mod batch;
mod case;
mod checkpoint;
mod kept;
mod output;
mod page;
mod screen;

pub(crate) use batch::BatchArgs;
pub(crate) use case::CaseArgs;
pub(crate) use checkpoint::CheckpointArgs;
pub(crate) use kept::KeptArgs;
pub(crate) use output::{OutputArgs, output};
pub(crate) use page::PageArgs;
pub(crate) use screen::ScreenOptions;
