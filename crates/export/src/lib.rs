//! Surveys, tallies and results in the formats of other programs: WITSML 1.4.1.1, 2.0 and 2.1, and
//! the fixed-width text of survey reports.
//!
//! The input is the contents of a case in SI; a [`Look`] gives the names and the units of the file.
//! Numbers keep [`DIGITS`] significant digits in WITSML; a report has the usual number of decimals.
#![warn(missing_docs)]

mod log;
mod look;
mod number;
mod report;
mod survey;
mod tally;
mod witsml;

pub use log::{Curve, Log};
pub use look::Look;
pub use number::{DIGITS, number};
pub use report::survey_report;
pub use survey::{Row, rows};
pub use tally::Component;
pub use witsml::{Version, logs, trajectory, tubular};
