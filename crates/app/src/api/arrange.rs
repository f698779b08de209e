//! Renaming, copying and deleting case files.

use axum::{
    extract::{Path, Query, State},
    http::StatusCode,
};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(rename)).routes(routes!(copy)).routes(routes!(delete))
}

/// The new name of a case file within its folder.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Named {
    /// The name, which ends in `.toml`.
    file_name: String,
}

/// A renamed or copied case file.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Arranged {
    /// Identifier in requests.
    id: String,
}

/// Renames a case file within its folder, never over an existing one.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/rename",
    request_body = Named,
    responses((status = 200, body = Arranged), (status = 409, body = ApiError))
)]
async fn rename(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(new): Json<Named>,
) -> Result<Json<Arranged>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(Arranged { id: app.workspace.rename(&case, &new.file_name)? }))
    })
    .await
}

/// Copies a case file within its folder, never over an existing one.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/copy",
    request_body = Named,
    responses((status = 200, body = Arranged), (status = 409, body = ApiError))
)]
async fn copy(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(new): Json<Named>,
) -> Result<Json<Arranged>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(Arranged { id: app.workspace.copy(&case, &new.file_name)? }))
    })
    .await
}

/// The revision of a file at the time of the decision to delete it.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(crate) struct Seen {
    /// Its revision.
    revision: String,
}

/// Deletes a case file and its draft, unless the file has changed since.
#[utoipa::path(
    delete,
    path = "/api/cases/{id}",
    params(Seen),
    responses((status = 204), (status = 404, body = ApiError), (status = 409, body = ApiError))
)]
async fn delete(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(seen): Query<Seen>,
) -> Result<StatusCode, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        app.workspace.remove(&case, &seen.revision)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}
