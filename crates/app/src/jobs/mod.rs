//! Work that takes longer than an answer: what the command line does with a case, one after the
//! other on a thread of its own.
//!
//! A job is known by its id in `.wholestring/jobs` of the folder, so that a server that is started
//! again knows what the one before it has begun. Its results lie where the command line puts them.

mod carry_out;
mod ended;
mod error;
mod job;
mod prepared;
mod progress;
mod queue;
mod work;

pub(crate) use error::JobError;
pub(crate) use job::{Job, State};
pub(crate) use progress::Progress;
pub(crate) use queue::Jobs;
pub(crate) use work::JobRequest;
