//! The folder that confines all access: cases, drafts, results.
//!
//! Its contents are named by ids, which are looked up among the existing paths and never made into
//! one.

mod arrange;
mod beside;
mod case_file;
mod draft;
mod error;
mod find;
mod folder;
mod job_file;
mod kept;
mod name;
mod other_file;
mod own;
mod results_folder;
mod walk;
mod write;

pub(crate) use case_file::{CaseFile, NewFile};
pub(crate) use draft::{Draft, millis};
pub(crate) use error::WorkspaceError;
pub(crate) use folder::Workspace;
pub(crate) use kept::KeptFile;
pub(crate) use other_file::OtherFile;
pub(crate) use results_folder::{ResultsFile, ResultsPlace};
