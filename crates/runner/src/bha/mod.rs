//! Static analysis of the bottom-hole assembly: side force and tilt of the bit, contacts, bending
//! and sag; also at other tool faces, weights and inclinations.

mod nodes;
mod page;
mod page_tables;
mod points;
mod request;

pub use points::Sweeps;
pub use request::{AtRest, Outcome, Request, at_rest, run};
