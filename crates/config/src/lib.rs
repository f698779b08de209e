//! Settings files in TOML, declared once: [`table!`](table::table) generates from one declaration
//! the struct, its reader, the names that misspellings are compared with, and the JSON schema.
//!
//! [`tagged!`](tagged::tagged) does so for groups of keys among which a word of the table chooses.
//!
//! All mistakes of a file are found in one pass and reported together, each with its place
//! underlined, the expected form and the nearest valid name. The crate declares no table itself:
//! cases and studies declare theirs.
//!
//! ```
//! use wholestring_config::{Json, diagnostic::Report, file, kind::Kind, prelude::*};
//!
//! table! {
//!     /// A pump.
//!     Pump in "the pump" {
//!         /// Rate that it is built for.
//!         rate: f64 = required(Quantity::si(
//!             Dimension::FlowRate,
//!             Range::positive_to(1.0),
//!             "2000 L/min",
//!         ));
//!         /// Part of its power that moves the mud.
//!         efficiency: f64 = default(Number { unit: "", range: Range::from_to(0.0, 1.0) }, 0.9);
//!     }
//! }
//!
//! fn tables() -> &'static Json {
//!     static TABLES: std::sync::LazyLock<Json> = std::sync::LazyLock::new(Pump::schema);
//!     &TABLES
//! }
//! static PUMP_FILE: Kind = Kind { noun: "pump", needs: "it needs a rate", tables };
//!
//! fn read(text: &str) -> Result<(f64, f64), Report> {
//!     let (root, mut reader) = file::tree("pump.toml", text.as_bytes(), &PUMP_FILE)?;
//!     let pump = Pump::read(&root, Span::default(), &mut reader);
//!     match (pump.rate.get(), pump.efficiency.get()) {
//!         (Some(rate), Some(efficiency)) if !reader.has_errors() => Ok((*rate, *efficiency)),
//!         _ => Err(reader.into_report()),
//!     }
//! }
//!
//! assert_eq!(read("rate = \"0.06 m3/s\"").unwrap(), (0.06, 0.9));
//! let refused = read("rat = \"0.06 m3/s\"").unwrap_err().render(false);
//! assert!(refused.contains("did you mean `rate`?"));
//! ```
#![warn(missing_docs)]

mod bare;
pub mod diagnostic;
pub mod file;
pub mod invisible;
pub mod kind;
pub mod names;
mod nesting;
pub mod node;
pub mod number;
pub mod prelude;
pub mod quantity;
pub mod range;
pub mod reader;
pub mod rule;
pub mod schema;
pub mod source;
pub mod table;
pub mod table_schema;
pub mod tagged;
pub mod usual;

/// A JSON schema, or a part of one.
pub use serde_json::Value as Json;
