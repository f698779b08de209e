//! Results in the folder: lists, files, pages, and comparisons.

mod compared;
mod curves;
mod entry;
mod verdict;

pub(crate) use compared::{Compared, compare};
pub(crate) use entry::{Found, POLICY, ResultsEntry, checks, page};
pub(crate) use verdict::{CaseVerdict, NewestVerdicts, Verdicts};
