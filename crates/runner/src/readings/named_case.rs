//! A case and the name of its file.

use wholestring_case::{Case, Override, Template};

/// A case with the name of its file, without extension.
#[derive(Debug, Clone)]
pub struct NamedCase<'a> {
    /// Name of its file.
    pub file: String,
    /// Text of the case, which is read again with the changes of a row of readings.
    pub template: &'a Template,
    /// Changes of the case for all rows.
    pub overrides: &'a [Override],
    /// The case.
    pub case: &'a Case,
}
