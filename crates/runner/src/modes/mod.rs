//! Linear vibration about static equilibrium: natural frequencies, critical speeds and the response
//! to a rotating force.

mod page;
mod request;
mod stability;
mod tables;

pub use request::{Outcome, Request, run};
pub use wholestring_report::stability_sentences;
