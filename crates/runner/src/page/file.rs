//! The file of a page.

/// Name of the file.
pub(crate) const FILE: &str = "report.html";
