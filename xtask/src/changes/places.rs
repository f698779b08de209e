//! Paths of patches and table, from the root of the repository.

/// Folder of the patches.
pub(super) const PATCHES: &str = "docs/changes";

/// File with the table.
pub(super) const TABLE: &str = "CONTRIBUTING.md";
