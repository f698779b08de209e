//! Work that takes longer than a request: the commands of the command line, one after the other on
//! a thread of its own.
//!
//! A job is identified by its id in `.wholestring/jobs` of the folder, so that a restarted server
//! finds the jobs of its predecessor. Its results are in the folder that the command line uses.

mod job;
mod prepared;
mod progress;
mod queue;

pub(crate) use job::{Job, State};
pub(crate) use prepared::{JobError, JobRequest};
pub(crate) use progress::Progress;
pub(crate) use queue::Jobs;
