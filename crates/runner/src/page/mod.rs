//! `report.html`: pages and pictures of results, made from their files.

pub(crate) mod dimensions;
pub(crate) mod facts;
mod file;
mod frames;
pub(crate) mod history;
pub(crate) mod inputs;
mod page_tables;
mod picture;
mod profile;
mod results;
mod rows;
mod run;
pub(crate) mod spectra;
mod tables;
pub(crate) mod well;

pub(crate) use file::FILE;
pub use picture::write_picture;
pub(crate) use profile::{PROFILE, write_profile};
pub(crate) use run::{along_the_hole, complete, gather, lacking, page, write};
pub(crate) use tables::{Tables, read_rows, rows_of, table};
pub use well::well_path;
pub(crate) use wholestring_report::PROGRAM;
pub use wholestring_report::display_units;
