//! Results, the survey and the string of a case in the formats of other programs.

mod logs;
mod request;
mod survey;
mod tally;
mod text;
mod workbook;

pub use request::{Exported, Format, Request, What, export};
