//! The one folder that nothing leaves: cases, drafts, results.
//!
//! What lies in it is named by ids, which are found among what is there and never made into a path.

mod arrange;
mod beside;
mod case_file;
mod draft;
mod error;
mod find;
mod folder;
mod kept;
mod name;
mod write;

pub(crate) use case_file::{CaseFile, NewFile};
pub(crate) use draft::{Draft, millis};
pub(crate) use error::WorkspaceError;
pub(crate) use folder::Workspace;
pub(crate) use kept::KeptFile;
