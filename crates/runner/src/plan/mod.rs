//! Torque and drag at every depth of the bit, with low, expected and high friction.

mod campaign;
mod charts;
mod files;
mod levels;
mod mud;
mod outcome;
pub(crate) mod page;
mod request;
mod rows;
mod work;
mod workbook;

pub use outcome::{Outcome, run};
pub use request::Request;
