//! Changes to a text that leave the rest as it was written.

use axum::extract::{Path, State};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_case::{Edit, edit as edit_text};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(edit))
}

/// A text and what is to be changed in it.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Changes {
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
pub(crate) enum Change {
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
pub(crate) struct Set {
    /// The key.
    set: String,
    /// Its value.
    to: Value,
}

/// A key, or an item of a list, goes.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Remove {
    /// The key.
    remove: String,
}

/// A list gets an item; a list that is missing is made.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Insert {
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
pub(crate) struct Move {
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
pub(crate) struct Changed {
    /// The text.
    text: String,
}

/// Changes a text; comments, and all that is not named, stay as they are. No file is written.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/edit",
    request_body = Changes,
    responses(
        (status = 200, body = Changed),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn edit(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(Changes { text, changes }): Json<Changes>,
) -> Result<Json<Changed>, ApiError> {
    blocking(move || {
        app.workspace.case(&id)?;
        let changes: Vec<Edit> = changes.into_iter().map(Edit::from).collect();
        let text = edit_text(&text, &changes);
        let text = text.map_err(|error| ApiError::bad_input(error.to_string()))?;
        Ok(Json(Changed { text }))
    })
    .await
}
