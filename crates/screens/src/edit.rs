//! Changes to a text that keep the rest as it was written.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;
use wholestring_case::{Edit, edit as edit_text};

use crate::{refusal::Refusal, values::CaseValue};

/// A text and its changes.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Changes {
    /// The text.
    text: String,
    /// The changes, applied in order.
    changes: Vec<Change>,
}

/// A change. Keys are dotted, with the indices of items from 0: `well.hole.0.friction`.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(
    untagged,
    expecting = "a change is {set, to}, {remove}, {insert, at, value} or {move, from, to}"
)]
pub enum Change {
    /// Sets the value of a key.
    Set(Set),
    /// Removes a key, or an item of a list.
    Remove(Remove),
    /// Inserts an item into a list.
    Insert(Insert),
    /// Moves an item of a list.
    Move(Move),
}

/// Sets the value of a key; missing tables on the way to it are created.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Set {
    /// The key.
    set: String,
    /// Its value.
    #[schema(value_type = CaseValue)]
    to: Value,
}

/// Removes a key, or an item of a list.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Remove {
    /// The key.
    remove: String,
}

/// Inserts an item into a list; a missing list is created.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Insert {
    /// The key of the list.
    insert: String,
    /// The index of the item afterwards, from 0.
    at: usize,
    /// The item.
    #[schema(value_type = CaseValue)]
    value: Value,
}

/// Moves an item of a list.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Move {
    /// The key of the list.
    #[serde(rename = "move")]
    list: String,
    /// Its index, from 0.
    from: usize,
    /// Its index afterwards.
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

/// A changed text.
#[derive(Debug, Serialize, ToSchema)]
pub struct Changed {
    /// The text.
    text: String,
}

/// Changes a text; comments and all unnamed keys stay unchanged.
///
/// # Errors
/// A change that does not fit the text.
pub fn edit(Changes { text, changes }: Changes) -> Result<Changed, Refusal> {
    let changes: Vec<Edit> = changes.into_iter().map(Edit::from).collect();
    let text = edit_text(&text, &changes);
    let text = text.map_err(|error| Refusal::bad_input(error.to_string()))?;
    Ok(Changed { text })
}
