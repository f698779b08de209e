//! Error responses.

use std::fmt::Display;

use axum::{
    http::StatusCode,
    response::{IntoResponse, Response},
};
use serde::Serialize;
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
    pub(crate) fn conflict(message: impl Into<String>) -> Self {
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
