//! Live answers for a text while it is edited.

use axum::extract::{Path, State};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_runner::CancellationToken;
use wholestring_screens::answers::{
    Answer, Asked, AskedOfModels, AskedOfOperation, AssemblyView, Broomstick,
};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(answer))
        .routes(routes!(broomstick))
        .routes(routes!(assembly))
}

/// Cancels the work when nobody waits for its result: a page with a newer request closes the
/// connection.
struct Waiting(CancellationToken);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Runs the work once a permit is free, for as long as the client waits for it.
async fn while_waited_for<T: Send + 'static>(
    app: App,
    work: impl FnOnce(&App, &CancellationToken) -> Result<T, ApiError> + Send + 'static,
) -> Result<T, ApiError> {
    let waiting = Waiting(CancellationToken::new());
    let turn = app.solving.clone().acquire_owned().await.map_err(ApiError::failed)?;
    let token = waiting.0.clone();
    blocking(move || {
        let _turn = turn;
        work(&app, &token)
    })
    .await
}

/// Solves the text by soft and stiff string. Nothing is written.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/answer",
    request_body = AskedOfModels,
    responses((status = 200, body = Answer), (status = 422, body = ApiError))
)]
async fn answer(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(request): Json<AskedOfModels>,
) -> Result<Json<Answer>, ApiError> {
    while_waited_for(app, move |app, cancellation| {
        let file = app.workspace.case(&id)?;
        let beside = app.workspace.beside(&file);
        Ok(Json(request.answer(&file.shown, &beside, cancellation)?))
    })
    .await
}

/// Hook load and torque against bit depth, with low, expected and high friction, by the soft
/// string.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/broomstick",
    request_body = Asked,
    responses((status = 200, body = Broomstick), (status = 422, body = ApiError))
)]
async fn broomstick(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(request): Json<Asked>,
) -> Result<Json<Broomstick>, ApiError> {
    while_waited_for(app, move |app, cancellation| {
        let file = app.workspace.case(&id)?;
        let beside = app.workspace.beside(&file);
        Ok(Json(request.broomstick(&file.shown, &beside, cancellation)?))
    })
    .await
}

/// Static analysis of the bottom-hole assembly: its shape in the hole and its loads on the bit.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/assembly",
    request_body = AskedOfOperation,
    responses((status = 200, body = AssemblyView), (status = 422, body = ApiError))
)]
async fn assembly(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(request): Json<AskedOfOperation>,
) -> Result<Json<AssemblyView>, ApiError> {
    while_waited_for(app, move |app, cancellation| {
        let file = app.workspace.case(&id)?;
        let beside = app.workspace.beside(&file);
        Ok(Json(request.assembly(&file.shown, &beside, cancellation)?))
    })
    .await
}
