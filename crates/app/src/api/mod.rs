//! The API, one module for each noun: each file declares its requests with their JSON, and the
//! document `/api/openapi.json` is made of the same declarations.

mod cases;
mod document;
mod edit;
pub(crate) mod error;
mod import;
mod jobs;
mod live;
mod live_socket;
mod program;
mod results;

use axum::{
    Router,
    extract::DefaultBodyLimit,
    http::{StatusCode, Uri},
};
use utoipa_axum::router::OpenApiRouter;

use error::ApiError;
pub(crate) use error::{Json, blocking};

use crate::{app::App, assets, limits::Limits};

/// The routes of all modules.
fn nouns(limits: &Limits) -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .merge(program::routes())
        .merge(cases::routes())
        .merge(edit::routes())
        .merge(live::routes())
        .merge(live_socket::routes())
        .merge(jobs::routes())
        .merge(results::routes())
        .merge(import::routes(limits))
}

/// All routes: the API, its description, and the page.
pub(crate) fn router(app: App) -> Router {
    let (router, document) = nouns(&app.limits).split_for_parts();
    router
        .merge(document::routes(document))
        .merge(assets::routes())
        .fallback(nothing)
        .method_not_allowed_fallback(other_method)
        .layer(DefaultBodyLimit::max(app.limits.json_bytes))
        .with_state(app)
}

async fn nothing(uri: Uri) -> ApiError {
    ApiError::not_found(format!("there is nothing at {}", uri.path()))
}

async fn other_method() -> ApiError {
    ApiError::new(
        StatusCode::METHOD_NOT_ALLOWED,
        "method_not_allowed",
        "this method is not allowed here",
    )
}
