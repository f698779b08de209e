//! A case and what its file is called.

use wholestring_case::Case;

/// A case with the name of its file, without its ending.
#[derive(Debug, Clone)]
pub struct NamedCase<'a> {
    /// Name of its file.
    pub file: String,
    /// The case.
    pub case: &'a Case,
}
