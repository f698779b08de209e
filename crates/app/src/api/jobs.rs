//! Jobs started from the page, and the studies and readings that they use.

use std::{convert::Infallible, time::Duration};

use axum::{
    extract::{Path, State},
    http::StatusCode,
    response::sse::{Event, KeepAlive, Sse},
};
use futures_util::{Stream, stream};
use serde::Serialize;
use tokio::{sync::watch, time::sleep};
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    jobs::{Job, JobRequest, Progress, State as JobState},
    workspace::{OtherFile, Workspace},
};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list, start))
        .routes(routes!(job, forget))
        .routes(routes!(stop))
        .routes(routes!(resume))
        .routes(routes!(events))
        .routes(routes!(studies))
        .routes(routes!(readings))
}

/// A job with its progress.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct JobView {
    #[serde(flatten)]
    job: Job,
    /// The id of its results, if there are any.
    results: Option<String>,
    /// Whether it can continue from its partial results; other jobs can start again.
    resumable: bool,
    progress: Progress,
}

impl JobView {
    fn of((job, progress): (Job, Progress)) -> Self {
        let has_stopped =
            matches!(job.state, JobState::Stopped | JobState::Interrupted | JobState::Failed);
        Self {
            results: job.folder.as_deref().map(Workspace::results_id),
            resumable: has_stopped && job.folder.is_some() && job.request.work.is_resumable(),
            job,
            progress,
        }
    }
}

/// A queued job.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Started {
    /// Identifier in requests.
    id: String,
}

/// All jobs of the folder, including those of earlier starts of the program, in the order of the
/// requests.
#[utoipa::path(get, path = "/api/jobs", responses((status = 200, body = Vec<JobView>)))]
async fn list(State(app): State<App>) -> Result<Json<Vec<JobView>>, ApiError> {
    blocking(move || Ok(Json(app.jobs.list().into_iter().map(JobView::of).collect()))).await
}

/// Queues work on a saved case. One job runs, the others wait.
#[utoipa::path(
    post,
    path = "/api/jobs",
    request_body = JobRequest,
    responses(
        (status = 200, body = Started),
        (status = 404, body = ApiError),
        (status = 409, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn start(
    State(app): State<App>,
    Json(request): Json<JobRequest>,
) -> Result<Json<Started>, ApiError> {
    blocking(move || Ok(Json(Started { id: app.jobs.start(request)? }))).await
}

/// A job.
#[utoipa::path(
    get,
    path = "/api/jobs/{id}",
    responses((status = 200, body = JobView), (status = 404, body = ApiError))
)]
async fn job(State(app): State<App>, Path(id): Path<String>) -> Result<Json<JobView>, ApiError> {
    blocking(move || Ok(Json(JobView::of(app.jobs.job(&id)?)))).await
}

/// Forgets an ended job. Its results stay.
#[utoipa::path(
    delete,
    path = "/api/jobs/{id}",
    responses(
        (status = 204),
        (status = 404, body = ApiError),
        (status = 409, body = ApiError)
    )
)]
async fn forget(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        app.jobs.forget(&id)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Stops a job. Its computed results are kept.
#[utoipa::path(
    post,
    path = "/api/jobs/{id}/stop",
    responses(
        (status = 204),
        (status = 404, body = ApiError),
        (status = 409, body = ApiError)
    )
)]
async fn stop(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        app.jobs.stop(&id)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Resumes a stopped job, with the case as saved now: if the case has changed, the results in the
/// folder are not continued. A job that cannot be continued starts again.
#[utoipa::path(
    post,
    path = "/api/jobs/{id}/resume",
    responses(
        (status = 204),
        (status = 404, body = ApiError),
        (status = 409, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn resume(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        app.jobs.resume(&id)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Minimum time between two events.
const PAUSE: Duration = Duration::from_millis(200);

/// A follower of a job.
struct Follower {
    app: App,
    id: String,
    changes: watch::Receiver<Progress>,
    /// Number of events so far.
    events: usize,
    is_over: bool,
}

impl Follower {
    /// The next state of the job. A slow reader gets the latest one, without those in between.
    async fn next(mut self) -> Option<(Result<Event, Infallible>, Self)> {
        if self.is_over {
            return None;
        }
        if self.events > 0 {
            sleep(PAUSE).await;
            self.changes.changed().await.ok()?;
        }
        self.changes.mark_unchanged();
        let (job, progress) = self.app.jobs.job(&self.id).ok()?;
        self.is_over = !job.state.is_open();
        self.events += 1;
        let event = Event::default().json_data(JobView::of((job, progress))).ok()?;
        Some((Ok(event), self))
    }
}

/// Progress of a job at each change: events of a [`JobView`] as JSON, until it ends.
#[utoipa::path(
    get,
    path = "/api/jobs/{id}/events",
    responses(
        (status = 200, body = JobView, content_type = "text/event-stream"),
        (status = 404, body = ApiError)
    )
)]
async fn events(
    State(app): State<App>,
    Path(id): Path<String>,
) -> Result<Sse<impl Stream<Item = Result<Event, Infallible>>>, ApiError> {
    let follower = blocking(move || {
        let changes = app.jobs.follow(&id)?;
        Ok(Follower { app, id, changes, events: 0, is_over: false })
    })
    .await?;
    Ok(Sse::new(stream::unfold(follower, Follower::next)).keep_alive(KeepAlive::default()))
}

// Studies and files of readings.

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
