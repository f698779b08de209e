//! Whose a folder is: results of one case are never replaced by those of another in silence, and no
//! two programs write to one folder, but for the shards of one sweep.

mod folder;
mod leftovers;
mod refusal;

pub(crate) use folder::{Claim, Claimed, hold};
pub(crate) use leftovers::remove as clear;
pub use refusal::FolderRefused;
