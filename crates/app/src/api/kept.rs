//! Live strings saved in the folder.

use std::sync::Arc;

use axum::{
    extract::{Path, State},
    http::StatusCode,
};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::live::{Beginning, KeptEntry, LiveId, Start};

use super::{Json, blocking, error::ApiError, live::case_of};
use crate::{app::App, live::kept};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(list)).routes(routes!(go_on, remove))
}

/// The saved strings, the latest first.
#[utoipa::path(get, path = "/api/kept-strings", responses((status = 200, body = Vec<KeptEntry>)))]
async fn list(State(app): State<App>) -> Result<Json<Vec<KeptEntry>>, ApiError> {
    blocking(move || Ok(Json(kept::all(&app.workspace)))).await
}

/// Continues a saved string as a live string, which is initially paused.
#[utoipa::path(
    post,
    path = "/api/kept-strings/{name}",
    responses(
        (status = 200, body = LiveId),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError),
        (status = 429, body = ApiError)
    )
)]
async fn go_on(State(app): State<App>, Path(name): Path<String>) -> Result<Json<LiveId>, ApiError> {
    blocking(move || {
        let moment = kept::of_name(&app.workspace, &name)?;
        let (text, case) = case_of(&app, &moment.case_id, Some(moment.text))?;
        let start = Start::At { bytes: Arc::new(moment.checkpoint), events: moment.events };
        let from = Beginning { case_id: moment.case_id, text, case: Arc::new(case), start };
        Ok(Json(LiveId { id: app.live.begin(from)? }))
    })
    .await
}

/// Removes a saved string.
#[utoipa::path(
    delete,
    path = "/api/kept-strings/{name}",
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn remove(State(app): State<App>, Path(name): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        app.workspace.remove_kept(&name)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}
