//! Torque and drag at every depth of the bit, with low, expected and high friction.

mod campaign;
mod files;
mod mud;
pub(crate) mod page;
mod request;
mod rows;
mod work;
mod workbook;

pub use request::{Outcome, Request, run};
