//! Example cases.

use axum::extract::Path;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::examples::{self, Example, ExampleEntry};

use super::{Json, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(list)).routes(routes!(example))
}

/// The example cases: the commented one, and wells.
#[utoipa::path(get, path = "/api/examples", responses((status = 200, body = Vec<ExampleEntry>)))]
async fn list() -> Json<Vec<ExampleEntry>> {
    Json(examples::list())
}

/// An example case with its text.
#[utoipa::path(
    get,
    path = "/api/examples/{name}",
    responses((status = 200, body = Example), (status = 404, body = ApiError))
)]
async fn example(Path(name): Path<String>) -> Result<Json<Example>, ApiError> {
    Ok(Json(examples::example(&name)?))
}
