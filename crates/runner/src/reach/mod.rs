//! Maximum reach of a well in its last direction, and the limit that stops it.

mod operations;
mod page;
mod request;
mod sample;
mod sentences;
mod tables;

pub(crate) use operations::operation;
pub use request::{Outcome, Request, run};
pub use sentences::{answers, notes};

pub use crate::uncertain::{notes as uncertain_notes, scatter};
