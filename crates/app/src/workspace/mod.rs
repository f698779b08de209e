//! The folder that confines all access: cases, drafts, results.
//!
//! Its contents are named by ids, which are looked up among the existing paths and never made into
//! one.

mod case_file;
mod folder;
mod kept;
mod leftovers;
mod other_file;
mod own;
mod results_folder;

pub(crate) use case_file::{CaseFile, NewFile};
pub(crate) use folder::{Workspace, WorkspaceError};
pub(crate) use kept::{Draft, KeptFile, millis};
pub(crate) use other_file::OtherFile;
pub(crate) use own::fingerprint;
pub(crate) use results_folder::{ResultsFile, ResultsPlace};
