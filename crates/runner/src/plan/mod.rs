//! Torque and drag at every depth of the bit, with low, expected and high friction.

mod broomstick;
mod campaign;
mod charts;
mod counted;
mod drawn;
mod dynamic;
mod files;
mod governing;
mod inputs_sheet;
mod kind;
mod left_out;
mod measured;
mod mud;
mod outcome;
mod overlay;
mod packed_checks;
pub(crate) mod page;
mod request;
mod roadmap_sheet;
mod rows;
mod sample;
mod surface;
mod verdict_sheet;
mod work;
mod workbook;

pub use broomstick::{BroomstickFound, BroomstickRequest, broomstick};
pub use governing::governing_sentences;
pub use outcome::{Outcome, run};
pub use overlay::Overlay;
pub use request::Request;

pub use wholestring_plan::Statics;

pub use crate::uncertain::{notes, scatter};
