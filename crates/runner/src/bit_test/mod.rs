//! A bit test: the bit alone on its rock, under every weight at every speed.

mod checks;
mod page;
mod point_checkpoint;
mod points;
mod request;
mod tables;
mod trials;

pub use request::{Outcome, Request, run};
