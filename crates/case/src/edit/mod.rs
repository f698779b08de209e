//! Changes to the text of a case by programs: keys set and removed, items of lists put in, taken out
//! and moved. What they leave alone stays as it was written, comments too.
//!
//! [`edited`](crate::edited) takes the changes of a command line, with their short keys and units;
//! these take whole keys and JSON, and change lists.

mod array;
mod place;
mod tables;
mod value;

use serde_json::Value as Json;
use toml_edit::DocumentMut;

/// A change. Keys are dotted, with the numbers of items from 0: `well.hole.0.friction`.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// A key gets a value; tables on the way to it that are missing are made.
    Set {
        /// The key.
        key: String,
        /// Its value. An object in the place of a table changes what differs.
        to: Json,
    },
    /// A key, or an item of a list, goes.
    Remove {
        /// The key.
        key: String,
    },
    /// A list gets an item; a list that is missing is made.
    Insert {
        /// The key of the list.
        list: String,
        /// The place that the item has then.
        at: usize,
        /// The item.
        value: Json,
    },
    /// An item of a list gets another place.
    Move {
        /// The key of the list.
        list: String,
        /// Its place.
        from: usize,
        /// The place that it has then.
        to: usize,
    },
}

/// Why a text cannot be changed so.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// There is nothing to change in it.
    #[error("the text is not TOML: {0}")]
    NotToml(String),
    /// A key that leads nowhere.
    #[error("`{key}` cannot be changed: {why}")]
    Key {
        /// The key.
        key: String,
        /// What is wrong with it.
        why: String,
    },
}

/// The text with these changes, one after the other. Whether the case is valid,
/// [`parse`](crate::parse) says.
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
/// A text that is no TOML, and a change of what is not there.
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
    // A library that writes what it cannot read would be found here, not by whoever opens the file.
    match edited.parse::<DocumentMut>() {
        Ok(_) => Ok(edited),
        Err(error) => Err(EditError::NotToml(error.message().to_owned())),
    }
}

#[cfg(test)]
mod tests;
