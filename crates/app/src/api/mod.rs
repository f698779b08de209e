//! The API, one module for each noun: each file declares its requests with their JSON, and the
//! document `/api/openapi.json` is made of the same declarations.

mod answers;
mod arrange;
mod blocking;
mod body;
mod cases;
mod catalogue;
mod check;
mod compare;
mod document;
mod drafts;
mod edit;
pub(crate) mod error;
mod examples;
mod import;
mod jobs;
mod kept;
mod live;
mod live_socket;
mod other_files;
mod results;
mod schema;
mod session;
mod survey;
mod units;

use axum::{
    Router,
    extract::DefaultBodyLimit,
    http::{StatusCode, Uri},
};
use utoipa_axum::router::OpenApiRouter;

pub(crate) use blocking::blocking;
pub(crate) use body::Json;
use error::ApiError;

use crate::{app::App, assets};

/// The routes of all modules.
fn nouns() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .merge(session::routes())
        .merge(examples::routes())
        .merge(cases::routes())
        .merge(arrange::routes())
        .merge(drafts::routes())
        .merge(check::routes())
        .merge(edit::routes())
        .merge(schema::routes())
        .merge(units::routes())
        .merge(survey::routes())
        .merge(catalogue::routes())
        .merge(answers::routes())
        .merge(live::routes())
        .merge(live_socket::routes())
        .merge(kept::routes())
        .merge(other_files::routes())
        .merge(jobs::routes())
        .merge(results::routes())
        .merge(compare::routes())
        .merge(import::routes())
}

/// All routes: the API, its description, and the page.
pub(crate) fn router(app: App) -> Router {
    let (router, document) = nouns().split_for_parts();
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
