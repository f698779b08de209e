//! The description of the case file for programs.

use axum::{
    http::header,
    response::{IntoResponse, Response},
};
use utoipa_axum::{router::OpenApiRouter, routes};

use super::Json;
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(schema))
}

/// The JSON schema of the case file, as printed by `wholestring schema`.
#[utoipa::path(get, path = "/api/schema", responses((status = 200, body = Object)))]
async fn schema() -> Response {
    let headers = [(header::CONTENT_TYPE, "application/schema+json")];
    (headers, Json(wholestring_case::schema())).into_response()
}
