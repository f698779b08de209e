//! Static analysis of the bottom-hole assembly: side force and tilt of the bit, contacts, bending,
//! sag; at other tool faces, weights and inclinations too.

mod nodes;
mod page;
mod page_tables;
mod points;
mod request;

pub use points::Sweeps;
pub use request::{AtRest, Outcome, Request, at_rest, run};
