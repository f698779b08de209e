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

mod assembly;
mod auto;
mod beside;
mod bit;
mod bit_test;
mod blades;
mod body;
mod bore;
mod buckling;
mod build;
mod case;
mod case_table;
mod casing;
mod catalogue;
mod component;
mod dimension;
mod dynamics;
mod edit;
mod edited;
mod effort;
mod ends;
mod fit;
mod hole;
mod identity;
mod joints;
mod likeness;
mod measured;
mod mesh;
mod model_rule;
mod modes;
mod mud;
mod named_size;
mod narrowed;
mod new_case;
mod operation;
mod operation_kind;
mod overrides;
mod parts;
mod plan;
mod plan_campaign;
mod plan_depths;
mod plan_dynamic;
mod plan_factors;
mod plan_models;
mod programme;
mod records;
mod rig;
mod rock;
mod roughness;
pub mod rules;
mod schedule;
mod schema;
mod settings;
mod stations;
mod steel;
mod string;
mod template;
mod top_drive;
mod tortuosity;
mod tubular_rules;
mod uncertain;
mod uncertain_check;
mod uncertain_table;
mod unit_set;
mod vary;
mod well;
mod words;

pub use bit_test::BitTest;
pub use build::parse;
pub use case::Case;
pub use catalogue::{OwnCatalogue, catalogue_schema};
pub use dimension::{dimension_at, dimension_of, unit_of_key};
pub use edit::{Edit, EditError, edit};
pub use edited::edited;
pub use hole::MAX_FRICTION;
pub use likeness::is_case;
pub use measured::Measured;
pub use modes::Modes;
pub use new_case::new_case;
pub use operation_kind::operation_named;
pub use overrides::{Override, OverrideError, Quote, long_key};
pub use parts::Parts;
pub use plan::Plan;
pub use records::Records;
pub use schedule::refused_set_point;
pub use schema::schema;
pub use steel::STEEL_DENSITY_KG_PER_M3;
pub use template::{Template, load};
pub use top_drive::usual_speed_controllers;
pub use uncertain::{Uncertain, UncertainInput};
pub use vary::{Variation, read_values};
pub use wholestring_config::{
    diagnostic::{Diagnostic, Label, Report, Severity},
    source::{Disk, Files, InMemory, Source, Span, read_file},
};
