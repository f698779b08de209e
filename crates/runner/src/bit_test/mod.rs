//! A bit test: the bit alone on its rock, at every weight and every speed.

mod checks;
mod page;
mod point_checkpoint;
mod points;
mod request;
mod tables;
mod trials;

pub use request::{Outcome, Request, run};
