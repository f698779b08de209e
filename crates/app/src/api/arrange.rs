//! Case files get another name, a copy, or go.

use axum::{
    extract::{Path, Query, State},
    http::StatusCode,
};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(rename)).routes(routes!(copy)).routes(routes!(delete))
}

/// The name that a case file is to have in its folder.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Named {
    /// The name, which ends in `.toml`.
    file_name: String,
}

/// A case file that has got its name.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Arranged {
    /// What requests call it.
    id: String,
}

/// Gives a case file another name in its folder, never that of a file that is there.
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

/// Makes a copy of a case file in its folder, never over one that is there.
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

/// What the file was when one decided that it goes.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(crate) struct Seen {
    /// Its revision.
    revision: String,
}

/// Deletes a case file, unless it is another by now, and its draft.
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
