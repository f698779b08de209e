//! Strings in motion: the driller's seat.

use std::sync::Arc;

use axum::{
    extract::{Path, State},
    http::StatusCode,
};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_case::{Case, parse};

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    live::{Beginning, Layout, LiveError, LiveState, RecordedEvent, Start, Status, with_schedule},
};

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list, begin))
        .routes(routes!(layout, end))
        .routes(routes!(rewind))
        .routes(routes!(branch))
        .routes(routes!(keep))
        .routes(routes!(recording))
        .routes(routes!(schedule))
}

impl From<LiveError> for ApiError {
    fn from(error: LiveError) -> Self {
        let message = error.to_string();
        match error {
            LiveError::Nothing(_) => Self::not_found(message),
            LiveError::Refused(_) => Self::bad_input(message),
            LiveError::Ended(_) => Self::new(StatusCode::GONE, "ended", message),
            LiveError::TooMany(_) => Self::new(StatusCode::TOO_MANY_REQUESTS, "too_many", message),
            LiveError::Failed(_) => Self::failed(message),
        }
    }
}

/// A string that is to be live.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewString {
    /// The id of its case.
    case: String,
    /// The text, as it stands in the editor; that of the file where there is none.
    text: Option<String>,
    /// Name of the operation; the only one where none is named.
    operation: Option<String>,
}

/// A string that is live.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct LiveId {
    /// What requests call it.
    pub(super) id: String,
}

/// A live string in a list.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct LiveEntry {
    /// What requests call it.
    id: String,
    /// The id of its case.
    case: String,
    /// What the case calls itself.
    name: String,
    /// Name of the operation.
    operation: &'static str,
    /// What it does.
    state: LiveState,
    /// Why, where that is to be said.
    sentence: Option<String>,
    /// Simulated time, s.
    time_s: f64,
    /// Pages that look at it.
    viewers: usize,
}

/// The live strings, and those that have ended of late.
#[utoipa::path(get, path = "/api/live", responses((status = 200, body = Vec<LiveEntry>)))]
async fn list(State(app): State<App>) -> Json<Vec<LiveEntry>> {
    let entry = |id: &str, case: &str, name: &str, operation, status: &Status| LiveEntry {
        id: id.to_owned(),
        case: case.to_owned(),
        name: name.to_owned(),
        operation,
        state: status.state,
        sentence: status.sentence.clone(),
        time_s: status.time_s,
        viewers: status.viewers,
    };
    let (running, ended) = app.live.all();
    let running = running.iter().map(|string| {
        let Layout { id, case, name, operation, .. } = &string.layout;
        entry(id, case, name, operation, &string.status().borrow())
    });
    let ended =
        ended.iter().map(|one| entry(&one.id, &one.case, &one.name, one.operation, &one.status));
    Json(running.chain(ended).collect())
}

/// The case of a text.
pub(super) fn case_of(
    app: &App,
    id: &str,
    text: Option<String>,
) -> Result<(String, Case), ApiError> {
    let file = app.workspace.case(id)?;
    let text = match text {
        Some(text) => text,
        None => file.read()?.text,
    };
    let case = parse(&file.shown, text.as_bytes(), &app.workspace.beside(&file), &[])?;
    Ok((text, case))
}

/// Begins a string at time zero. It waits to be run; this takes a second or more.
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

/// What a viewer has to know of it before its first frame.
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

/// Ends it; nothing of it is kept.
#[utoipa::path(
    delete,
    path = "/api/live/{id}",
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn end(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    app.live.string(&id)?.end("somebody has ended this string", false);
    Ok(StatusCode::NO_CONTENT)
}

/// A checkpoint that a string is to be taken back to.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Back {
    /// Its number.
    checkpoint: u64,
    /// Whether what was set after it is set again, each at its time. It is forgotten otherwise.
    #[serde(default)]
    replay: bool,
}

/// Goes back to a checkpoint. Those that come after it are forgotten.
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

/// A moment of a string.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct At {
    /// Number of a checkpoint; now where there is none.
    checkpoint: Option<u64>,
}

/// Begins another string from a moment of this one.
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
    let kept = app.live.moment(&string, at.checkpoint).await?;
    blocking(move || {
        let start = Start::At { bytes: Arc::new(kept.checkpoint), events: kept.events };
        let case = string.case();
        let from = Beginning { case_id: kept.case_id, text: kept.text, case, start };
        Ok(Json(LiveId { id: app.live.begin(from)? }))
    })
    .await
}

/// A string that is kept.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct KeptName {
    /// What requests call it.
    name: String,
}

/// Keeps a moment of a string in the folder, to be continued another time.
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
    let kept = app.live.moment(&string, at.checkpoint).await?;
    blocking(move || Ok(Json(KeptName { name: kept.keep(&app.workspace)? }))).await
}

/// What was set so far, and when.
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

/// A text that is to have what was done in its schedule.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TextOfCase {
    /// The text.
    text: String,
}

/// A text that has the schedule.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Scheduled {
    /// The text.
    text: String,
    /// Lines that were added.
    lines: usize,
    /// What no schedule can say, in sentences.
    left_out: Vec<String>,
}

/// Writes what was done into `[[operation.schedule]]` of a text. No file is written.
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
        let case_id = &string.layout.case;
        let (text, case) = case_of(&app, case_id, Some(text))?;
        let made = with_schedule(&text, &case, &string.events());
        let made = made.map_err(|error| ApiError::bad_input(error.to_string()))?;
        // What comes out is a sound case, or it is said why not.
        case_of(&app, case_id, Some(made.text.clone()))?;
        Ok(Json(Scheduled { text: made.text, lines: made.lines, left_out: made.left_out }))
    })
    .await
}
