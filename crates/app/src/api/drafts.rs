//! Unsaved drafts.

use axum::{
    extract::{Path, State},
    http::StatusCode,
};
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, cases::Revised, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(keep, discard))
}

/// Saves a draft.
#[utoipa::path(
    put,
    path = "/api/cases/{id}/draft",
    request_body = Revised,
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn keep(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(typed): Json<Revised>,
) -> Result<StatusCode, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        app.workspace.keep_draft(&case, typed.text, typed.revision)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Removes a draft.
#[utoipa::path(
    delete,
    path = "/api/cases/{id}/draft",
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn discard(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        app.workspace.remove_draft(&case)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}
