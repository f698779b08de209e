//! A survey pasted from a spreadsheet.

use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::survey::{self, Pasted, Survey};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(survey))
}

/// Reads rows as `import` reads a survey file: columns by their headings, which also give the
/// units. Nothing is written.
#[utoipa::path(
    post,
    path = "/api/survey",
    request_body = Pasted,
    responses((status = 200, body = Survey), (status = 422, body = ApiError))
)]
async fn survey(Json(pasted): Json<Pasted>) -> Result<Json<Survey>, ApiError> {
    blocking(move || Ok(Json(survey::survey(&pasted)?))).await
}
