//! Static analysis of the bottom-hole assembly: side force and tilt of the bit, contacts, bending
//! and sag; also at other tool faces, weights and inclinations.

mod nodes;
mod numbers;
mod page;
mod page_tables;
mod points;
mod request;
mod tendency;

pub use numbers::{number, plain, quantity};
pub use points::Sweeps;
pub use request::{AtRest, Outcome, Request, at_rest, run};
pub use tendency::tendency;
