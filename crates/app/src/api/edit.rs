//! Changes to a text that keep the rest as it was written.

use axum::extract::{Path, State};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::{
    edit::{self, Changed, Changes},
    trial::{Applied, Applying},
};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(edit)).routes(routes!(apply))
}

/// Changes a text; comments and all unnamed keys stay unchanged. No file is written.
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
    Json(changes): Json<Changes>,
) -> Result<Json<Changed>, ApiError> {
    blocking(move || {
        app.workspace.case(&id)?;
        Ok(Json(edit::edit(changes)?))
    })
    .await
}

/// Writes trial values into a text, and returns the changes. No file is written.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/apply",
    request_body = Applying,
    responses(
        (status = 200, body = Applied),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn apply(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(applying): Json<Applying>,
) -> Result<Json<Applied>, ApiError> {
    blocking(move || {
        let file = app.workspace.case(&id)?;
        let beside = app.workspace.beside(&file);
        Ok(Json(applying.apply(&file.shown, &beside)?))
    })
    .await
}
