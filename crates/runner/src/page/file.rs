//! The file of a page, and what made it.

/// Name of the file.
pub(crate) const FILE: &str = "report.html";

/// What made the page.
pub(crate) const PROGRAM: &str = concat!("wholestring ", env!("CARGO_PKG_VERSION"));
