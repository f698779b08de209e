//! A text while it is edited: changes that keep the rest as it was written, diagnostics, live
//! answers, and a survey pasted from a spreadsheet.

use axum::extract::{Path, State};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_runner::CancellationToken;
use wholestring_screens::{
    answers::{Answer, Asked, AskedOfModels, AskedOfOperation, AssemblyView, Broomstick},
    check::{self, Checked, Text},
    edit::{self, Changed, Changes},
    survey::{self, Pasted, Survey},
    trial::{Applied, Applying},
};

use super::{Json, blocking, error::ApiError};
use crate::app::App;

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(edit))
        .routes(routes!(apply))
        .routes(routes!(check))
        .routes(routes!(answer))
        .routes(routes!(broomstick))
        .routes(routes!(assembly))
        .routes(routes!(survey))
}

/// Changes a text; comments and all unnamed keys stay unchanged. No file is written.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/edit",
    request_body = Changes,
    responses(
        (status = 200, body = Changed),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn edit(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(changes): Json<Changes>,
) -> Result<Json<Changed>, ApiError> {
    blocking(move || {
        app.workspace.case(&id)?;
        Ok(Json(edit::edit(changes)?))
    })
    .await
}

/// Writes trial values into a text, and returns the changes. No file is written.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/apply",
    request_body = Applying,
    responses(
        (status = 200, body = Applied),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn apply(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(applying): Json<Applying>,
) -> Result<Json<Applied>, ApiError> {
    blocking(move || {
        let file = app.workspace.case(&id)?;
        let beside = app.workspace.beside(&file);
        Ok(Json(applying.apply(&file.shown, &beside)?))
    })
    .await
}

// Validation of a text as a case.

/// Returns the diagnostics of the command line for the text, as if it were in the file of the case.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/check",
    request_body = Text,
    responses((status = 200, body = Checked), (status = 404, body = ApiError))
)]
async fn check(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(Text { text }): Json<Text>,
) -> Result<Json<Checked>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(check::check(&case.shown, &text, &app.workspace.beside(&case))))
    })
    .await
}

// Live answers for a text while it is edited.

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

// A survey pasted from a spreadsheet.

/// Reads rows as `import` reads a survey file: columns by their headings, which also give the
/// units. Nothing is written.
#[utoipa::path(
    post,
    path = "/api/survey",
    request_body = Pasted,
    responses((status = 200, body = Survey), (status = 422, body = ApiError))
)]
async fn survey(Json(pasted): Json<Pasted>) -> Result<Json<Survey>, ApiError> {
    blocking(move || Ok(Json(survey::survey(&pasted)?))).await
}
