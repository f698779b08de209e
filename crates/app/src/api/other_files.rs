//! Studies and files of readings.

use axum::extract::State;
use serde::Serialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, error::ApiError};
use crate::{app::App, workspace::OtherFile};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(studies)).routes(routes!(readings))
}

/// A file of the folder.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct FileEntry {
    /// Identifier in requests.
    id: String,
    /// Path within the folder, for display.
    path: String,
}

impl From<OtherFile> for FileEntry {
    fn from(OtherFile { id, shown, .. }: OtherFile) -> Self {
        Self { id, path: shown }
    }
}

/// The study files of the folder.
#[utoipa::path(get, path = "/api/studies", responses((status = 200, body = Vec<FileEntry>)))]
async fn studies(State(app): State<App>) -> Result<Json<Vec<FileEntry>>, ApiError> {
    blocking(move || Ok(Json(app.workspace.studies().into_iter().map(FileEntry::from).collect())))
        .await
}

/// Files of the folder that may hold readings: text and workbooks.
#[utoipa::path(get, path = "/api/readings", responses((status = 200, body = Vec<FileEntry>)))]
async fn readings(State(app): State<App>) -> Result<Json<Vec<FileEntry>>, ApiError> {
    blocking(move || Ok(Json(app.workspace.readings().into_iter().map(FileEntry::from).collect())))
        .await
}
