//! Changes to a text that leave the rest as it was written.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_case::{Edit, edit as edit_text};

use crate::refusal::Refusal;

/// A text and what is to be changed in it.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Changes {
    /// The text.
    text: String,
    /// One after the other.
    changes: Vec<Change>,
}

/// A change. Keys are dotted, with the numbers of items from 0: `well.hole.0.friction`.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(
    untagged,
    expecting = "a change is {set, to}, {remove}, {insert, at, value} or {move, from, to}"
)]
pub enum Change {
    /// A key gets a value.
    Set(Set),
    /// A key, or an item of a list, goes.
    Remove(Remove),
    /// A list gets an item.
    Insert(Insert),
    /// An item of a list gets another place.
    Move(Move),
}

/// A key gets a value; tables on the way to it that are missing are made.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Set {
    /// The key.
    set: String,
    /// Its value.
    to: Value,
}

/// A key, or an item of a list, goes.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Remove {
    /// The key.
    remove: String,
}

/// A list gets an item; a list that is missing is made.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Insert {
    /// The key of the list.
    insert: String,
    /// The place that the item has then, from 0.
    at: usize,
    /// The item.
    value: Value,
}

/// An item of a list gets another place.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Move {
    /// The key of the list.
    #[serde(rename = "move")]
    list: String,
    /// Its place, from 0.
    from: usize,
    /// The place that it has then.
    to: usize,
}

impl From<Change> for Edit {
    fn from(change: Change) -> Self {
        match change {
            Change::Set(Set { set, to }) => Self::Set { key: set, to },
            Change::Remove(Remove { remove }) => Self::Remove { key: remove },
            Change::Insert(Insert { insert, at, value }) => {
                Self::Insert { list: insert, at, value }
            }
            Change::Move(Move { list, from, to }) => Self::Move { list, from, to },
        }
    }
}

/// A text that was changed.
#[derive(Debug, Serialize, ToSchema)]
pub struct Changed {
    /// The text.
    text: String,
}

/// Changes a text; comments, and all that is not named, stay as they are.
///
/// # Errors
/// A change that the text does not take.
pub fn edit(Changes { text, changes }: Changes) -> Result<Changed, Refusal> {
    let changes: Vec<Edit> = changes.into_iter().map(Edit::from).collect();
    let text = edit_text(&text, &changes);
    let text = text.map_err(|error| Refusal::bad_input(error.to_string()))?;
    Ok(Changed { text })
}
