//! Live strings: the driller's seat, and strings saved in the folder.

use std::sync::Arc;

use axum::{
    extract::{Path, State},
    http::StatusCode,
};
use serde::Serialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_case::{Case, parse};
use wholestring_screens::live::{
    At, Back, Beginning, KeptEntry, Layout, LiveEntry, LiveId, NewString, RecordedEvent, Scheduled,
    Start, TextOfCase, schedule as scheduled,
};

use super::{Json, blocking, error::ApiError};
use crate::{app::App, live};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list, begin))
        .routes(routes!(layout, end))
        .routes(routes!(rewind))
        .routes(routes!(branch))
        .routes(routes!(keep))
        .routes(routes!(recording))
        .routes(routes!(schedule))
        .routes(routes!(kept))
        .routes(routes!(go_on, remove))
}

/// The live strings, and those that have ended recently.
#[utoipa::path(get, path = "/api/live", responses((status = 200, body = Vec<LiveEntry>)))]
async fn list(State(app): State<App>) -> Json<Vec<LiveEntry>> {
    let (running, ended) = app.live.all();
    let running = running.iter().map(|string| LiveEntry::of_string(string));
    let ended = ended
        .iter()
        .map(|one| LiveEntry::of(&one.id, &one.case, &one.name, one.operation, &one.status));
    Json(running.chain(ended).collect())
}

/// Parses the case of a text.
fn case_of(app: &App, id: &str, text: Option<String>) -> Result<(String, Case), ApiError> {
    let file = app.workspace.case(id)?;
    let text = match text {
        Some(text) => text,
        None => file.read()?.text,
    };
    let case = parse(&file.shown, text.as_bytes(), &app.workspace.beside(&file), &[])?;
    Ok((text, case))
}

/// Starts a live string at time zero, initially paused; this takes a second or more.
#[utoipa::path(
    post,
    path = "/api/live",
    request_body = NewString,
    responses(
        (status = 200, body = LiveId),
        (status = 422, body = ApiError),
        (status = 429, body = ApiError)
    )
)]
async fn begin(
    State(app): State<App>,
    Json(new): Json<NewString>,
) -> Result<Json<LiveId>, ApiError> {
    let turn = app.solving.clone().acquire_owned().await.map_err(ApiError::failed)?;
    blocking(move || {
        let _turn = turn;
        let NewString { case: case_id, text, operation } = new;
        let (text, case) = case_of(&app, &case_id, text)?;
        let start = Start::New { operation };
        let from = Beginning { case_id, text, case: Arc::new(case), start };
        Ok(Json(LiveId { id: app.live.begin(from)? }))
    })
    .await
}

/// Layout that a viewer needs before the first frame.
#[utoipa::path(
    get,
    path = "/api/live/{id}",
    responses(
        (status = 200, body = Layout),
        (status = 404, body = ApiError),
        (status = 410, body = ApiError)
    )
)]
async fn layout(State(app): State<App>, Path(id): Path<String>) -> Result<Json<Layout>, ApiError> {
    Ok(Json(app.live.string(&id)?.layout.clone()))
}

/// Ends the string without saving it.
#[utoipa::path(
    delete,
    path = "/api/live/{id}",
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn end(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    app.live.string(&id)?.end("this string was ended by a user", false);
    Ok(StatusCode::NO_CONTENT)
}

/// Returns to a checkpoint. Later ones are discarded.
#[utoipa::path(
    post,
    path = "/api/live/{id}/rewind",
    request_body = Back,
    responses((status = 204), (status = 404, body = ApiError), (status = 410, body = ApiError))
)]
async fn rewind(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(back): Json<Back>,
) -> Result<StatusCode, ApiError> {
    app.live.string(&id)?.rewind(back.checkpoint, back.replay).await?;
    Ok(StatusCode::NO_CONTENT)
}

/// Starts another string from a moment of this one.
#[utoipa::path(
    post,
    path = "/api/live/{id}/branch",
    request_body = At,
    responses(
        (status = 200, body = LiveId),
        (status = 404, body = ApiError),
        (status = 410, body = ApiError),
        (status = 429, body = ApiError)
    )
)]
async fn branch(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(at): Json<At>,
) -> Result<Json<LiveId>, ApiError> {
    let string = app.live.string(&id)?;
    let moment = string.kept_at(at.checkpoint).await?;
    blocking(move || {
        let start = Start::At { bytes: Arc::new(moment.checkpoint), events: moment.events };
        let case = string.case();
        let from = Beginning { case_id: moment.case_id, text: moment.text, case, start };
        Ok(Json(LiveId { id: app.live.begin(from)? }))
    })
    .await
}

/// A saved string.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct KeptName {
    /// Identifier in requests.
    name: String,
}

/// Saves a moment of a string in the folder, to be continued later.
#[utoipa::path(
    post,
    path = "/api/live/{id}/keep",
    request_body = At,
    responses(
        (status = 200, body = KeptName),
        (status = 404, body = ApiError),
        (status = 410, body = ApiError)
    )
)]
async fn keep(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(at): Json<At>,
) -> Result<Json<KeptName>, ApiError> {
    let string = app.live.string(&id)?;
    let moment = string.kept_at(at.checkpoint).await?;
    blocking(move || Ok(Json(KeptName { name: live::keep_string(&moment, &app.workspace)? }))).await
}

/// The set points so far, with their times.
#[utoipa::path(
    get,
    path = "/api/live/{id}/recording",
    responses((status = 200, body = Vec<RecordedEvent>), (status = 404, body = ApiError))
)]
async fn recording(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Json<Vec<RecordedEvent>>, ApiError> {
    Ok(Json(app.live.string(&id)?.events()))
}

/// Writes the recorded actions as `[[operation.schedule]]` into a text. No file is written.
#[utoipa::path(
    post,
    path = "/api/live/{id}/schedule",
    request_body = TextOfCase,
    responses(
        (status = 200, body = Scheduled),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn schedule(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(TextOfCase { text }): Json<TextOfCase>,
) -> Result<Json<Scheduled>, ApiError> {
    blocking(move || {
        let string = app.live.string(&id)?;
        let file = app.workspace.case(&string.layout.case)?;
        let beside = app.workspace.beside(&file);
        Ok(Json(scheduled(&text, &string.events(), &file.shown, &beside)?))
    })
    .await
}

// Live strings saved in the folder.

/// The saved strings, the latest first.
#[utoipa::path(
    get,
    path = "/api/kept-strings",
    operation_id = "list",
    responses((status = 200, body = Vec<KeptEntry>))
)]
async fn kept(State(app): State<App>) -> Result<Json<Vec<KeptEntry>>, ApiError> {
    blocking(move || Ok(Json(live::kept_strings(&app.workspace)))).await
}

/// Continues a saved string as a live string, which is initially paused.
#[utoipa::path(
    post,
    path = "/api/kept-strings/{name}",
    responses(
        (status = 200, body = LiveId),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError),
        (status = 429, body = ApiError)
    )
)]
async fn go_on(State(app): State<App>, Path(name): Path<String>) -> Result<Json<LiveId>, ApiError> {
    blocking(move || {
        let moment = live::kept_string(&app.workspace, &name)?;
        let (text, case) = case_of(&app, &moment.case_id, Some(moment.text))?;
        let start = Start::At { bytes: Arc::new(moment.checkpoint), events: moment.events };
        let from = Beginning { case_id: moment.case_id, text, case: Arc::new(case), start };
        Ok(Json(LiveId { id: app.live.begin(from)? }))
    })
    .await
}

/// Removes a saved string.
#[utoipa::path(
    delete,
    path = "/api/kept-strings/{name}",
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn remove(State(app): State<App>, Path(name): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        app.workspace.remove_kept(&name)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}
