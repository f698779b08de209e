//! Results, the survey and the string of a case in the formats of other programs.

mod first_sheets;
mod format;
mod logs;
mod made;
mod request;
mod source;
mod survey;
mod tally;
mod text;
mod timestamp;
mod workbook;

pub use format::{Format, What};
pub use request::{Exported, Request, export};
pub use wholestring_export::Version as WitsmlVersion;
