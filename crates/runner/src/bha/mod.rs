//! Static analysis of the bottom-hole assembly: side force and tilt of the bit, contacts, bending
//! and sag; also at other tool faces, weights and inclinations.

mod page;
mod points;
mod request;

pub use points::Sweeps;
pub use request::{AtRest, Outcome, Request, at_rest, run};
pub use wholestring_report::{
    bha_number as number, bha_quantity as quantity, bha_tendency as tendency,
};
