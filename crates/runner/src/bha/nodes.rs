//! The table of the nodes, which identifies a folder of BHA results.

/// Name of the table, without its extension.
pub(super) const NODES: &str = "bha";
