//! Where examples of changes are, and the table that counts their files.

/// Folder of the patches.
pub(super) const PATCHES: &str = "docs/changes";

/// File with the table.
pub(super) const TABLE: &str = "CONTRIBUTING.md";
