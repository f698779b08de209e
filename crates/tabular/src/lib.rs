//! Surveys, tallies, and readings at the surface, from CSV, text reports and Excel.
//!
//! Columns are found by their headings, in any order and in common spellings: `MD (m)`,
//! `Measured Depth ( ft )`, `md_m`, `INCL`, `Azimuth Grid [deg]`. Units are in the headings or in a
//! row below them. The reader accepts titles and comments above the header; commas, semicolons,
//! tabs or blanks between the columns; decimal commas and thousands separators.
//! [`ImportedSurvey::notes`] lists the recognised contents.
//!
//! No value is guessed where an error would go unnoticed: lengths without any unit are an error
//! until their unit is [given](Said). With a unit, three columns need no header either. Angles
//! without a unit are in degrees, which is noted.
//!
//! ```
//! let text = "MD (ft),Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n";
//! let survey = wholestring_tabular::read(text.as_bytes(), "a.csv")?;
//! assert_eq!(survey.stations[1].md_m, 304.8);
//!
//! let error = wholestring_tabular::read(b"MD (ft),Inc,Azi\n0,0,0\nx,0,0\n", "a.csv");
//! assert_eq!(
//!     error.unwrap_err().to_string(),
//!     "a.csv, line 3, column 1: 'x' is not a number; the measured depth was expected"
//! );
//! # Ok::<(), wholestring_tabular::TableError>(())
//! ```
#![warn(missing_docs)]

mod bit;
mod cells;
mod columns;
mod error;
mod held;
mod read;
mod reading_checks;
mod readings;
mod row_names;
mod sheets;
mod stabiliser;
mod survey;
mod tally;

pub use bit::is_bit;
pub use cells::{decode::single_bytes, number::is_null, table::is_comment};
pub use columns::column::Column;
pub use error::{Place, TableError, TableErrorKind};
pub use held::{Held, held, read_tally};
pub use read::{read, read_all, read_as, read_csv, read_excel, read_readings};
pub use reading_checks::CHANNEL_WORDS;
pub use readings::{ImportedReading, ImportedReadings};
pub use row_names::row_names;
pub use sheets::{SheetText, UNCALCULATED, is_workbook, sheets};
pub use stabiliser::is_stabiliser;
pub use survey::{
    doubts::{StationDoubt, station_doubts},
    imported::{ImportedSurvey, StatedPosition, SurveyTable, under_origin},
    places::{StationPlaces, within_a_turn},
    positions::{PositionCheck, position_checks},
    preamble::{About, Stated},
    said::Said,
    surface::{straight_start, surface_doubts},
};
pub use tally::{Holds, ImportedTally, TallyCell, TallyRow, TallyTotal};
