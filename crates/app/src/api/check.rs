//! Validation of a text as a case.

use axum::extract::{Path, State};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::check::{self, Checked, Text};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(check))
}

/// Returns the diagnostics of the command line for the text, as if it were in the file of the case.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/check",
    request_body = Text,
    responses((status = 200, body = Checked), (status = 404, body = ApiError))
)]
async fn check(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(Text { text }): Json<Text>,
) -> Result<Json<Checked>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(check::check(&case.shown, &text, &app.workspace.beside(&case))))
    })
    .await
}
