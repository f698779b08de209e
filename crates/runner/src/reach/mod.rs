//! Maximum reach of a well in its last direction, and the limit that stops it.

mod checks;
mod operations;
mod page;
mod request;
mod sample;
mod tables;

pub(crate) use operations::operation;
pub use request::{Outcome, Request, run};
pub use wholestring_report::{reach_answers as answers, reach_notes as notes};

pub use crate::uncertain::{notes as uncertain_notes, scatter};
