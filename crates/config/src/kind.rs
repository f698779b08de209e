//! Kinds of files: a case file, a study file.

use serde_json::Value as Json;

/// A kind of file.
#[derive(Debug)]
pub struct Kind {
    /// Its name in messages.
    pub noun: &'static str,
    /// Its minimum contents, for the message about an empty one.
    pub needs: &'static str,
    /// The schema of its tables.
    pub tables: fn() -> &'static Json,
}
