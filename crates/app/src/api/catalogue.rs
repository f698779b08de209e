//! What a case can name, and what rigs commonly have.

use axum::extract::Query;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::catalogue::{self, Catalogue, Wanted};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(catalogue))
}

/// What `wholestring catalogue WORD` finds.
#[utoipa::path(
    get,
    path = "/api/catalogue",
    params(Wanted),
    responses((status = 200, body = Catalogue))
)]
async fn catalogue(Query(wanted): Query<Wanted>) -> Result<Json<Catalogue>, ApiError> {
    blocking(move || Ok(Json(catalogue::catalogue(&wanted)))).await
}
