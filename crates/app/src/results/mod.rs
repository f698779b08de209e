//! What commands have left in the folder: lists, files, pages, and results side by side.

mod compared;
mod curves;
mod entry;
mod findings;
mod inputs;
mod page;
mod scalars;

pub(crate) use compared::{Compared, compare};
pub(crate) use entry::ResultsEntry;
pub(crate) use findings::{Found, findings};
pub(crate) use page::{POLICY, page};
