//! The description of the API for programs.

use axum::{Router, http::header, response::IntoResponse, routing::get};
use utoipa::openapi::{Info, OpenApi};

use crate::app::App;

/// `GET /api/openapi.json`.
pub(super) fn routes(mut document: OpenApi) -> Router<App> {
    document.info = Info::new("wholestring app", env!("CARGO_PKG_VERSION"));
    // It consists of strings and lists; if serialization failed, the empty text would reveal it.
    let text = serde_json::to_string(&document).unwrap_or_default();
    let answer = async move || ([(header::CONTENT_TYPE, "application/json")], text).into_response();
    Router::new().route("/api/openapi.json", get(answer))
}
