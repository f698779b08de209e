//! Execution of the work that front ends request: runs, sweeps, studies, bit tests and analyses,
//! with their checkpoints, pages and pictures.
//!
//! A front end loads a case, creates a request and passes it with an [`Observer`], which receives
//! the progress, and a [`CancellationToken`], which stops the work. It gets an outcome, or an
//! [`Error`]. Nothing here prints, reads arguments or uses a terminal; results are written to
//! folders, whose files `wholestring-results` describes.
//!
//! | module | carries out |
//! |---|---|
//! | [`job`] | any of the following commands, with its options as a user writes them |
//! | [`run`] | one case, operation after operation |
//! | [`sweep`] | a case with all combinations of some values |
//! | [`study`] | cases and sweeps, with the figures and tables to make of them |
//! | [`bha`] | static analysis of the bottom-hole assembly |
//! | [`bit_test`] | the bit alone on its rock |
//! | [`mod@calibrate`] | friction factors from readings at the surface |
//! | [`modes`] | natural frequencies, critical speeds and the response to a rotating force |
//! | [`plan`] | torque and drag at every depth of the bit, with low, expected and high friction |
//! | [`reach`] | the maximum reach of a well, and the limit that stops it |
//! | [`import`] | a case from the files of other programs |
//! | [`mod@export`] | results, surveys and strings in the formats of other programs |
//! | [`mod@bench`] | the speed of a machine |
//!
//! [`Comparison`] contains the results of a run next to each other, [`survey`] the positions along
//! a survey, and [`Found`] entries of the catalogue. [`write_report`] and [`pictures()`] rewrite
//! the page and the pictures of results in a folder.
//!
//! ```
//! use wholestring_runner::{CancellationToken, Silent, run};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let place = tempfile::tempdir()?;
//! # let results = place.path().to_owned();
//! # let file = std::path::Path::new("../../cases/slant.toml");
//! let case = wholestring_case::load(file, &["model=soft".parse()?]).expect("a valid case");
//! let mut request = run::Request::new(&case);
//! request.output.folder = Some(results);
//!
//! let outcome = run::run(&request, &Silent, &CancellationToken::new())?.finished()?;
//! for solved in &outcome.summary.operations {
//!     println!("{}: {} N", solved.operation, solved.scalars.hook_load_N);
//!     assert!(solved.scalars.hook_load_N > 0.0);
//! }
//! assert!(outcome.folder.join("nodes.parquet").is_file());
//! # Ok(())
//! # }
//! ```
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod batch;
pub mod bench;
pub mod bha;
pub mod bit_test;
pub mod calibrate;
mod cancellation;
mod catalogue;
mod checkpoint;
pub mod checks;
mod claim;
mod clock;
mod comparison;
mod copy;
mod cores;
mod error;
pub mod export;
mod folder_name;
pub mod import;
pub mod job;
mod keep;
pub mod modes;
mod observer;
mod output;
mod pace;
mod page;
mod parallel;
mod picture_table;
pub mod plan;
pub mod reach;
mod readings;
mod record;
mod results_kind;
mod results_kinds;
pub mod run;
mod shard;
mod share;
mod sheet;
pub mod study;
pub mod survey;
pub mod sweep;
mod tasks;
mod uncertain;

pub use batch::{BatchOptions, BatchOutcome, CaseWithErrors, FailedCase};
pub use cancellation::CancellationToken;
pub use catalogue::Found;
pub use claim::FolderRefused;
pub use clock::Instant;
pub use comparison::{ComparedColumn, ComparedRow, Comparison, Deviation, Drift};
pub use copy::copy_results;
pub use error::{Error, Unsound};
pub use keep::Keep;
pub use observer::{BatchSize, CaseEnded, Observer, Progress, Silent, Task, Trial};
pub use output::{Existing, Output};
pub use page::write_picture;
pub use results_kinds::{check_summary, pictures, pictures_folder, results_kind, write_report};
pub use shard::Shard;
pub use wholestring_report::{display_units, well_path};
