//! A job: one of the nine commands that write a results folder, with its options as a user writes
//! them.
//!
//! The command line, the app and Python fill the same [`Job`]. [`Job::prepare`] reads its files and
//! checks its options, and [`PreparedJob::run`] executes it.

mod commands;
mod files;
mod input;
mod options;
mod outcome;
mod prepared;
mod request;
mod work;

pub use files::{CaseInput, DataInput, JobFiles, OnDisk};
pub use options::operation;
pub use outcome::JobOutcome;
pub use prepared::PreparedJob;
pub use request::Job;
pub use work::{
    BhaOptions, CalibrateOptions, CasesOptions, ReachOptions, StudyOptions, SweepOptions, Varied,
    Work,
};
