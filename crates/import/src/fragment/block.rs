//! A table of a case: keys with values and their origins.

use super::{Origin, Value};

/// A key of the case file with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The key, as in the case file.
    pub key: &'static str,
    /// Its value.
    pub value: Value,
    /// Its origin.
    pub origin: Origin,
}

/// A table of the case file, or one of several.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// Comment above it.
    pub remark: Option<String>,
    /// Its keys, in the order of the file.
    pub entries: Vec<Entry>,
}

impl Block {
    /// Adds a key.
    pub fn push(&mut self, key: &'static str, value: Value, origin: Origin) {
        self.entries.push(Entry { key, value, origin });
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.entries.iter().find(|entry| entry.key == key).map(|entry| &entry.value)
    }
}
