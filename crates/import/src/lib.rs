//! Cases from the files of other programs: surveys and tallies in text and Excel, WITSML, Landmark
//! EDM, LAS and the logs of a rig.
//!
//! Each file gives a [`Fragment`]: parts of a case whose every value has its place and text in the
//! file. [`import`] joins the fragments of several files and writes one commented case. No value is
//! guessed silently: a unit that is missing in a file is an error that names the [`Choices`], and
//! every assumption and omission is written to the case as a sentence.
//!
//! ```
//! use wholestring_import::{Choices, Input, import};
//!
//! let survey = b"MD (ft),Inc,Azi\n0,0,0\n1000,0,0\n1100,3,45\n";
//! let files = vec![Input::of_bytes("survey.csv", survey)];
//! let imported = import(files, &Choices::default())?;
//! assert!(imported.text.contains("[\"1100 ft\", 3, 45]"));
//! // No string, no hole and no mud: the case lists the missing parts.
//! assert_eq!(imported.missing.len(), 3);
//! # Ok::<(), wholestring_import::ImportError>(())
//! ```
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod case_text;
mod choices;
mod doubts;
mod edm;
mod error;
mod format;
mod fragment;
mod import;
mod input;
mod log;
mod merge;
mod pipe;
mod readings_csv;
mod tables;
mod witsml;
mod xml;

/// Weights and torques picked from a log against time.
pub mod picking {
    pub use crate::log::picking::{
        BelowBottom, BlockWeight, Channel, Counts, Detail, Estimate, Kind, Motion, Picks, Refusal,
        Refused, Thresholds, Trace, Trip, Window, Work, pick,
    };
}

pub use choices::Choices;
pub use error::{ImportError, ImportErrorKind};
pub use format::Format;
pub use fragment::{Block, Contents, Entry, Fragment, Note, Origin, Part, Survey, Value};
pub use import::{Beside, Imported, contents, import};
pub use input::Input;
pub use log::{Channel, Log, Quantity, Record, log};
