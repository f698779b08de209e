//! Small motions about the string at rest: natural frequencies, critical speeds and the answer to a
//! rotating force.

mod page;
mod request;
mod shapes;
mod stability;
mod tables;

pub use request::{Outcome, Request, run};
pub use stability::sentences as stability_sentences;
