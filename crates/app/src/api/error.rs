//! Error responses, and the JSON bodies and the work outside the threads of the server that end in
//! them.

use std::fmt::Display;

use axum::{
    extract::{FromRequest, Request, rejection::JsonRejection},
    http::StatusCode,
    response::{IntoResponse, Response},
};
use serde::{Serialize, de::DeserializeOwned};
use utoipa::ToSchema;
use wholestring_case::Report;
use wholestring_screens::{
    live::LiveError,
    refusal::{ErrorDetails, Refusal},
};

use crate::{jobs::JobError, workspace::WorkspaceError};

/// Error response: `{"error": {...}}`.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct ApiError {
    #[serde(skip)]
    status: StatusCode,
    error: ErrorDetails,
}

impl ApiError {
    /// A response with this status.
    pub(crate) fn new(status: StatusCode, kind: &'static str, message: impl Into<String>) -> Self {
        Self::from(Refusal::new(status.as_u16(), kind, message))
    }

    /// The object does not exist.
    pub(crate) fn not_found(message: impl Into<String>) -> Self {
        Self::from(Refusal::not_found(message))
    }

    /// The request is invalid.
    pub(crate) fn bad_input(message: impl Into<String>) -> Self {
        Self::from(Refusal::bad_input(message))
    }

    /// The present contents differ from those that the client has read.
    fn conflict(message: impl Into<String>) -> Self {
        Self::new(StatusCode::CONFLICT, "conflict", message)
    }

    /// An operation failed unexpectedly, for example because of a full disk.
    pub(crate) fn failed(error: impl Display) -> Self {
        Self::from(Refusal::failed(error))
    }
}

impl From<Refusal> for ApiError {
    fn from(Refusal { status, error }: Refusal) -> Self {
        let status = StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
        Self { status, error }
    }
}

/// Errors of live strings.
impl From<LiveError> for ApiError {
    fn from(error: LiveError) -> Self {
        Self::from(Refusal::from(error))
    }
}

/// Errors of the folder.
impl From<WorkspaceError> for ApiError {
    fn from(error: WorkspaceError) -> Self {
        let message = error.to_string();
        match error {
            WorkspaceError::Nothing(_) => Self::not_found(message),
            WorkspaceError::Name { .. } => Self::bad_input(message),
            WorkspaceError::Exists(_) | WorkspaceError::Changed => Self::conflict(message),
            WorkspaceError::Folder { .. } | WorkspaceError::System { .. } => Self::failed(message),
        }
    }
}

/// Refused work.
impl From<JobError> for ApiError {
    fn from(error: JobError) -> Self {
        match error {
            JobError::Unsound(report) => Self::from(report),
            JobError::BadInput(message) => Self::bad_input(message),
            JobError::Conflict(message) => Self::conflict(message),
            JobError::Workspace(error) => Self::from(error),
        }
    }
}

/// An invalid case.
impl From<Report> for ApiError {
    fn from(report: Report) -> Self {
        Self::from(Refusal::from(report))
    }
}

impl IntoResponse for ApiError {
    fn into_response(self) -> Response {
        (self.status, axum::Json(&self)).into_response()
    }
}

// JSON bodies.

/// A body of JSON. As an argument, invalid JSON is answered as an [`ApiError`].
#[derive(Debug)]
pub(crate) struct Json<T>(pub(crate) T);

impl<S: Send + Sync, T: DeserializeOwned> FromRequest<S> for Json<T> {
    type Rejection = ApiError;

    async fn from_request(request: Request, state: &S) -> Result<Self, ApiError> {
        match axum::Json::from_request(request, state).await {
            Ok(axum::Json(value)) => Ok(Self(value)),
            Err(rejection) => Err(refused(&rejection)),
        }
    }
}

fn refused(rejection: &JsonRejection) -> ApiError {
    let kind = match rejection {
        JsonRejection::JsonDataError(_) | JsonRejection::JsonSyntaxError(_) => "bad_json",
        JsonRejection::MissingJsonContentType(_) => "not_json",
        JsonRejection::BytesRejection(_) => "bad_body",
        _ => "bad_request",
    };
    ApiError::new(rejection.status(), kind, rejection.body_text())
}

impl<T: Serialize> IntoResponse for Json<T> {
    fn into_response(self) -> Response {
        axum::Json(self.0).into_response()
    }
}

// Work that uses the processor or waits for the disk, outside the threads of the server.

/// Runs the work on a thread of its own. After a panic, the response is an error and the server
/// continues.
pub(crate) async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, ApiError> + Send + 'static,
) -> Result<T, ApiError> {
    match tokio::task::spawn_blocking(work).await {
        Ok(done) => done,
        Err(_) => {
            Err(ApiError::failed("internal error of the program; the request was not carried out"))
        }
    }
}
