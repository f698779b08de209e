//! The program: its folder, catalogue, units, description of the case file, and examples.

use std::collections::BTreeMap;

use axum::{
    extract::{Path, Query, State},
    http::header,
    response::{IntoResponse, Response},
};
use serde::Serialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_screens::{
    catalogue::{self, Catalogue, Wanted},
    examples::{self, Example, ExampleEntry},
    units::{self, DimensionUnits},
};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(session))
        .routes(routes!(catalogue))
        .routes(routes!(units))
        .routes(routes!(schema))
        .routes(routes!(list))
        .routes(routes!(example))
}

/// The program and its folder.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Session {
    /// The version of the program.
    version: &'static str,
    /// The name of the folder, without its path, which is not disclosed.
    folder_name: String,
}

/// The program and its folder.
#[utoipa::path(get, path = "/api/session", responses((status = 200, body = Session)))]
async fn session(State(app): State<App>) -> Json<Session> {
    let folder_name = app.workspace.name();
    Json(Session { version: env!("CARGO_PKG_VERSION"), folder_name })
}

// Catalogue of tubulars, and common rig equipment.

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

// All units, and the unit of each dimension in each set.

/// All dimensions by name.
#[utoipa::path(
    get,
    path = "/api/units",
    responses((status = 200, body = BTreeMap<String, DimensionUnits>))
)]
async fn units() -> Json<BTreeMap<String, DimensionUnits>> {
    Json(units::units())
}

// The description of the case file for programs.

/// The JSON schema of the case file, as printed by `wholestring schema`.
#[utoipa::path(get, path = "/api/schema", responses((status = 200, body = Object)))]
async fn schema() -> Response {
    let headers = [(header::CONTENT_TYPE, "application/schema+json")];
    (headers, Json(wholestring_case::schema())).into_response()
}

// Example cases.

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
