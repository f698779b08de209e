//! What a file is, and what it holds.

/// What a file is, and what it holds, in words.
#[derive(Debug, Clone, PartialEq)]
pub struct Contents {
    /// What it is: `a survey`, `WITSML 1.4.1.1`.
    pub what: String,
    /// What it holds, a line each: `tubular 'BHA 7': 12 components`.
    pub lines: Vec<String>,
}
