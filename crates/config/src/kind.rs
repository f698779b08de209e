//! What is read: a case file, a study file.

use serde_json::Value as Json;

/// A kind of file.
#[derive(Debug)]
pub struct Kind {
    /// What messages call it.
    pub noun: &'static str,
    /// What it needs at the least, for the message about an empty one.
    pub needs: &'static str,
    /// The schema of its tables.
    pub tables: fn() -> &'static Json,
}
