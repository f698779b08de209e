//! Surveys, tallies and results in the formats of other programs: WITSML 1.4.1.1, 2.0 and 2.1, and
//! the fixed-width text of survey reports.
//!
//! What goes out is what a case holds, SI inside; a [`Look`] says whose names and in which units.
//! Numbers keep [`DIGITS`] significant digits in WITSML; a report has as many decimals as reports
//! have.
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
