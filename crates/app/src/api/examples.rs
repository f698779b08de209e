//! Cases to begin with.

use axum::extract::Path;
use serde::Serialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, error::ApiError};
use crate::{app::App, examples};

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(list)).routes(routes!(example))
}

/// A case to begin with.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ExampleEntry {
    /// What it is asked for by, and a name for its file without the ending.
    name: &'static str,
    /// What it is, in a sentence.
    title: &'static str,
}

/// A case to begin with, whole.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Example {
    /// What it is asked for by.
    name: &'static str,
    /// What it is, in a sentence.
    title: &'static str,
    /// Its text.
    text: String,
    /// Files that it names.
    beside: Vec<ExampleFile>,
}

/// A file that an example names.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ExampleFile {
    /// Its name.
    file_name: &'static str,
    /// What it holds.
    text: &'static str,
}

/// The cases to begin with: the commented one, and wells.
#[utoipa::path(get, path = "/api/examples", responses((status = 200, body = Vec<ExampleEntry>)))]
async fn list() -> Json<Vec<ExampleEntry>> {
    let entry = |of: &examples::Example| ExampleEntry { name: of.name, title: of.title };
    Json(examples::EXAMPLES.iter().map(entry).collect())
}

/// A case to begin with, whole.
#[utoipa::path(
    get,
    path = "/api/examples/{name}",
    responses((status = 200, body = Example), (status = 404, body = ApiError))
)]
async fn example(Path(name): Path<String>) -> Result<Json<Example>, ApiError> {
    let found = examples::EXAMPLES.iter().find(|one| one.name == name);
    let found = found.ok_or_else(|| ApiError::not_found("there is no such example"))?;
    let beside = found.beside.iter().map(|(file_name, text)| ExampleFile { file_name, text });
    Ok(Json(Example {
        name: found.name,
        title: found.title,
        text: found.text(),
        beside: beside.collect(),
    }))
}
