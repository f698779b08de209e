//! The table of the nodes, by which a folder is known.

/// Name of it, without its extension.
pub(super) const NODES: &str = "bha";
