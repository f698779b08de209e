//! Study files: sweeps of cases, and the figures and tables to make of them.
//!
//! [`load`] and [`parse`] give a [`Study`], or a report that names every mistake at once. The
//! caller passes the available columns as [`ColumnName`]s, because a study has no access to
//! results. The cases themselves are read by the runner of the study.
//!
//! ```
//! use wholestring_study::{ColumnName, Source, parse};
//! use wholestring_units::Dimension;
//!
//! let columns = [ColumnName {
//!     source: Source::Summary,
//!     name: "hook_load_N",
//!     dimension: Some(Dimension::Force),
//! }];
//! let study = r#"
//! [[sweep]]
//! name = "deep"
//! case = "well.toml"
//! vary = { bit_depth = "300m..1500m/300m" }
//!
//! [[figure]]
//! title = "Hook load"
//! x = "bit_depth"
//! y = "hook_load_N"
//! "#;
//! let study = parse("study.toml", study.as_bytes(), &columns)?;
//! assert_eq!(study.sweeps[0].vary[0].values.len(), 5);
//! # Ok::<(), wholestring_case::Report>(())
//! ```
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod abscissa;
mod chosen;
mod column;
mod figure;
mod figure_table;
mod file_name;
mod numbers;
mod numbers_table;
mod row_table;
mod selection;
mod study;
mod sweep;
mod times_and_depths;

pub use abscissa::Abscissa;
pub use chosen::Chosen;
pub use column::{ColumnName, Quantity, Source, Statistic};
pub use figure::{Figure, FigureData, Level, Pointing};
pub use numbers::{Number, NumberTable, Row, Shape, Wanted};
pub use selection::Selection;
pub use study::{Study, load, parse, schema};
pub use sweep::{Exception, Sweep};
