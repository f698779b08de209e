//! Torque and drag at every depth of the bit, with low, expected and high friction.

mod campaign;
mod dynamic;
mod files;
mod levels;
mod mud;
mod outcome;
pub(crate) mod page;
mod peaks;
mod request;
mod rows;
mod work;
mod workbook;

pub use outcome::{Outcome, run};
pub use request::Request;
