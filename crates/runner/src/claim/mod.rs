//! Ownership of folders: results of one case never replace those of another silently, and no two
//! programs write to one folder, except the shards of one sweep.

mod folder;
mod leftovers;
mod refusal;

pub(crate) use folder::{Claim, Claimed, hold};
pub(crate) use leftovers::remove as remove_results;
pub use refusal::FolderRefused;
