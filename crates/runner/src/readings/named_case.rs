//! A case and what its file is called.

use wholestring_case::{Case, Override, Template};

/// A case with the name of its file, without its ending.
#[derive(Debug, Clone)]
pub struct NamedCase<'a> {
    /// Name of its file.
    pub file: String,
    /// Its text, to be read again with what a row of readings changes.
    pub template: &'a Template,
    /// What is changed in it for all rows.
    pub overrides: &'a [Override],
    /// The case.
    pub case: &'a Case,
}
