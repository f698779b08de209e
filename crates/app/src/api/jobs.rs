//! Work that is started from the page.

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
    workspace::Workspace,
};

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list, start))
        .routes(routes!(job, forget))
        .routes(routes!(stop))
        .routes(routes!(resume))
        .routes(routes!(events))
}

/// A job with how far it has come.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct JobView {
    #[serde(flatten)]
    job: Job,
    /// The id of its results, where there are some.
    results: Option<String>,
    /// Whether it can go on from what it has left; what cannot, can begin anew.
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

/// A job that was taken on.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Started {
    /// What requests call it.
    id: String,
}

/// All jobs of the folder, those of earlier starts of the program too, in the order in which they
/// were asked for.
#[utoipa::path(get, path = "/api/jobs", responses((status = 200, body = Vec<JobView>)))]
async fn list(State(app): State<App>) -> Result<Json<Vec<JobView>>, ApiError> {
    blocking(move || Ok(Json(app.jobs.list().into_iter().map(JobView::of).collect()))).await
}

/// Takes work on a saved case on. One job goes on, the others wait.
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

/// Forgets a job that has ended. Its results stay.
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

/// Stops a job. What it has computed is kept.
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

/// Goes on with a job that has stopped, with the case as it is saved now: where that is another, what
/// lies in the folder is not continued. What cannot be continued begins anew.
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

/// Time between two events at least.
const PAUSE: Duration = Duration::from_millis(200);

/// Someone who follows a job.
struct Follower {
    app: App,
    id: String,
    changes: watch::Receiver<Progress>,
    /// Events until now.
    events: usize,
    is_over: bool,
}

impl Follower {
    /// The state that the job has next. Who reads slowly gets the latest, and nothing in between.
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

/// How far a job has come, each time that it has: events of a [`JobView`] as JSON, until it ends.
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
