//! Torque and drag at every depth of the bit, with low, expected and high friction.

mod broomstick;
mod campaign;
mod charts;
mod drawn;
mod dynamic;
mod files;
mod first;
mod kind;
mod levels;
mod measured;
mod mud;
mod outcome;
mod overlay;
pub(crate) mod page;
mod peaks;
mod request;
mod rows;
mod sample;
mod surface;
mod weight;
mod work;
mod workbook;

pub use broomstick::{BroomstickFound, BroomstickRequest, broomstick};
pub use first::breaks_first;
pub use outcome::{Outcome, run};
pub use overlay::Overlay;
pub use request::Request;

pub use wholestring_plan::Statics;

pub use crate::uncertain::{notes, scatter};
