//! Surveys, tallies and results in the formats of other programs: WITSML 1.4.1.1, 2.0 and 2.1, and
//! the fixed-width text of survey reports.
//!
//! The input is the contents of a case in SI; a [`Look`] gives the names and the units of the file.
//! Numbers keep [`DIGITS`] significant digits in WITSML; a report has the usual number of decimals.
#![warn(missing_docs)]

mod look;
mod survey;
mod witsml;

pub use look::{DIGITS, Look, number};
pub use survey::{Row, rows, survey_report};
pub use witsml::{Component, Curve, Log, Version, logs, trajectory, tubular};
