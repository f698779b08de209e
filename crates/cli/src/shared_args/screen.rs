//! Options of the screen.

/// Options of the screen.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ScreenOptions {
    /// Prints nothing but errors.
    pub(crate) quiet: bool,
    /// Fails if a check of the results is an error.
    pub(crate) strict: bool,
    /// Prints the summary of a run as JSON in place of the table.
    pub(crate) json: bool,
}
