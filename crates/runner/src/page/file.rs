//! The file of a page, and the program that wrote it.

/// Name of the file.
pub(crate) const FILE: &str = "report.html";

/// Name and version of the program.
pub(crate) const PROGRAM: &str = concat!("wholestring ", env!("CARGO_PKG_VERSION"));
