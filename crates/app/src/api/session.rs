//! The program and its folder.

use axum::extract::State;
use serde::Serialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::Json;
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(session))
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
