//! Results in the folder: lists, files, pages, and comparisons.

mod checks;
mod compared;
mod curves;
mod entry;
mod inputs;
mod page;
mod scalars;
mod verdict;

pub(crate) use checks::{Found, checks};
pub(crate) use compared::{Compared, compare};
pub(crate) use entry::ResultsEntry;
pub(crate) use page::{POLICY, page};
pub(crate) use verdict::{CaseVerdict, Verdicts};
