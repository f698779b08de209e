//! Catalogue of tubulars, and common rig equipment.

use axum::extract::Query;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::catalogue::{self, Catalogue, Wanted};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(catalogue))
}

/// Entries that `wholestring catalogue WORD` finds.
#[utoipa::path(
    get,
    path = "/api/catalogue",
    params(Wanted),
    responses((status = 200, body = Catalogue))
)]
async fn catalogue(Query(query): Query<Wanted>) -> Result<Json<Catalogue>, ApiError> {
    blocking(move || Ok(Json(catalogue::catalogue(&query)))).await
}
