//! Changes to the text of a case by programs: keys are set and removed, items of lists inserted,
//! removed and moved. All other text is preserved, comments included.
//!
//! [`edited`](crate::edit::edited) applies the changes of a command line, with their short keys and
//! units; these changes have whole keys and JSON, and also change lists.

pub(crate) mod edited;
mod lists;
pub(crate) mod overrides;
pub(crate) mod vary;

mod place;
mod value;

use serde_json::Value as Json;
use toml_edit::DocumentMut;

/// A change. Keys are dotted, with the numbers of items from 0: `well.hole.0.friction`.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// Sets a key; missing tables on the way to it are created.
    Set {
        /// The key.
        key: String,
        /// Its value. An object in place of a table changes only the keys that differ.
        to: Json,
    },
    /// Removes a key, or an item of a list.
    Remove {
        /// The key.
        key: String,
    },
    /// Inserts an item into a list; a missing list is created.
    Insert {
        /// The key of the list.
        list: String,
        /// Index of the item after insertion.
        at: usize,
        /// The item.
        value: Json,
    },
    /// Moves an item of a list.
    Move {
        /// The key of the list.
        list: String,
        /// Its index.
        from: usize,
        /// Its index after the move.
        to: usize,
    },
}

/// The reason why a text cannot be changed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// The text is not TOML.
    #[error("the text is not TOML: {0}")]
    NotToml(String),
    /// A key that does not exist.
    #[error("`{key}` cannot be changed: {why}")]
    Key {
        /// The key.
        key: String,
        /// The reason.
        why: String,
    },
}

/// Returns the text with these changes, applied in order. Whether the case is valid is decided by
/// [`parse`](crate::parse).
///
/// ```
/// use wholestring_case::{Edit, edit};
///
/// let text = "[operation]\nrpm = 60 # slow\n";
/// let faster = Edit::Set { key: "operation.rpm".into(), to: 120.into() };
/// assert_eq!(edit(text, &[faster])?, "[operation]\nrpm = 120 # slow\n");
/// # Ok::<(), wholestring_case::EditError>(())
/// ```
///
/// # Errors
/// A text that is not TOML, and a change of a key that does not exist.
pub fn edit(text: &str, changes: &[Edit]) -> Result<String, EditError> {
    let text = text.trim_start_matches('\u{feff}');
    let mut document: DocumentMut = text
        .parse()
        .map_err(|error: toml_edit::TomlError| EditError::NotToml(error.message().to_owned()))?;
    for change in changes {
        let (key, applied) = match change {
            Edit::Set { key, to } => (key, place::set(&mut document, key, to)),
            Edit::Remove { key } => (key, place::remove(&mut document, key)),
            Edit::Insert { list, at, value } => {
                (list, place::insert(&mut document, list, *at, value))
            }
            Edit::Move { list, from, to } => (list, place::moved(&mut document, list, *from, *to)),
        };
        applied.map_err(|why| EditError::Key { key: key.clone(), why })?;
    }
    let edited = document.to_string();
    // Detects invalid output of the library here, before a user opens the file.
    match edited.parse::<DocumentMut>() {
        Ok(_) => Ok(edited),
        Err(error) => Err(EditError::NotToml(error.message().to_owned())),
    }
}

#[cfg(test)]
mod tests;
