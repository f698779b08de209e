//! What is answered where something cannot be.

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

/// A request that is not answered as it was meant: `{"error": {...}}`.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct ApiError {
    #[serde(skip)]
    status: StatusCode,
    error: ErrorDetails,
}

impl ApiError {
    /// An answer with this status.
    pub(crate) fn new(status: StatusCode, kind: &'static str, message: impl Into<String>) -> Self {
        Self::from(Refusal::new(status.as_u16(), kind, message))
    }

    /// There is no such thing.
    pub(crate) fn not_found(message: impl Into<String>) -> Self {
        Self::from(Refusal::not_found(message))
    }

    /// What was asked cannot be so.
    pub(crate) fn bad_input(message: impl Into<String>) -> Self {
        Self::from(Refusal::bad_input(message))
    }

    /// What stands there is not what the one who asks has seen.
    pub(crate) fn conflict(message: impl Into<String>) -> Self {
        Self::new(StatusCode::CONFLICT, "conflict", message)
    }

    /// It should have gone, and did not: a full disk, for one.
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

/// What a live string does not do.
impl From<LiveError> for ApiError {
    fn from(error: LiveError) -> Self {
        Self::from(Refusal::from(error))
    }
}

/// What the folder refuses.
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

/// Work that is not taken on.
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

/// A case that is invalid.
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
