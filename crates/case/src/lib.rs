//! Case files: a well, a string, a mud and an operation as a TOML text, read into the engine's
//! model.
//!
//! [`load`] and [`parse`] return a [`Case`] in which everything has been checked, or a [`Report`]
//! that lists all mistakes at once, each with its place underlined and the expected value.
//! [`schema`] describes the file for editors.
//!
//! A key is declared once, in the table that it belongs to; the declaration generates the reader,
//! the list of names that misspellings are compared with, and the schema.
//!
//! ```
//! use wholestring_case::{InMemory, parse};
//!
//! let mistaken = "[mud]\ndensty = \"1.2 sg\"\n";
//! let report = parse("well.toml", mistaken.as_bytes(), &InMemory::default(), &[]).unwrap_err();
//! assert!(report.render(false).contains("did you mean `density`?"));
//! ```
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod beside;
mod bit;
mod bit_test;
mod buckling;
mod case;
mod catalogue;
mod dynamics;
mod edit;
mod ends;
mod modes;
mod mud;
mod operation;
mod plan;
mod rig;
mod rock;
pub mod rules;
mod settings;
mod string;
mod uncertain;
mod values;
mod well;

pub use beside::Measured;
pub use bit_test::BitTest;
pub use case::{
    Case,
    build::parse,
    parts::Parts,
    table::schema,
    template::{Template, is_case, load, new_case},
};
pub use catalogue::{OwnCatalogue, catalogue_schema};
pub use dynamics::records::Records;
pub use edit::{
    Edit, EditError, edit,
    edited::edited,
    overrides::{Override, OverrideError, Quote, long_key},
    vary::{Variation, read_values},
};
pub use modes::Modes;
pub use operation::{kind::operation_named, schedule::refused_set_point};
pub use plan::Plan;
pub use rig::top_drive::usual_speed_controllers;
pub use string::steel::STEEL_DENSITY_KG_PER_M3;
pub use uncertain::{Uncertain, UncertainInput};
pub use values::dimension::{dimension_at, dimension_of, unit_of_key};
pub use well::hole::MAX_FRICTION;
pub use wholestring_config::{
    diagnostic::{Diagnostic, Label, Report, Severity},
    invisible::{described, invisible},
    source::{Disk, Files, InMemory, Source, Span, read_file},
};
