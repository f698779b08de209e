//! Small motions about the string at rest: natural frequencies, critical speeds and the answer to a
//! force that turns.

pub(crate) mod page;
mod request;
mod shapes;
mod tables;

pub use request::{Outcome, Request, run};
