//! Description of a file and its contents.

/// Description of a file and its contents, in words.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Contents {
    /// Kind of file: `a survey`, `WITSML 1.4.1.1`.
    pub what: String,
    /// Contents, one line each: `tubular 'BHA 7': 12 components`; warnings begin with `warning: `.
    pub lines: Vec<String>,
    /// Mistakes for which a calibration refuses the file, in sentences.
    pub errors: Vec<String>,
}
