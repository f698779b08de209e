//! Error responses.

use std::fmt::Display;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::Report;
use wholestring_runner::Error;

use crate::diagnostic::{self, Diagnostic};

/// Error response: `{"error": {...}}`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Refusal {
    /// The HTTP status.
    #[serde(skip)]
    pub status: u16,
    /// Details.
    pub error: ErrorDetails,
}

/// Details of an error.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ErrorDetails {
    /// Identifier for programs.
    pub kind: &'static str,
    /// Message for people.
    pub message: String,
    /// The diagnostics of the case, if it is invalid.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub diagnostics: Vec<Diagnostic>,
}

impl Refusal {
    /// A response with this status.
    pub fn new(status: u16, kind: &'static str, message: impl Into<String>) -> Self {
        let error = ErrorDetails { kind, message: message.into(), diagnostics: Vec::new() };
        Self { status, error }
    }

    /// The object does not exist.
    pub fn not_found(message: impl Into<String>) -> Self {
        Self::new(404, "not_found", message)
    }

    /// The request is invalid.
    pub fn bad_input(message: impl Into<String>) -> Self {
        Self::new(422, "bad_input", message)
    }

    /// An operation failed unexpectedly, for example because of a full disk.
    pub fn failed(error: impl Display) -> Self {
        Self::new(500, "failed", error.to_string())
    }
}

/// An invalid case.
impl From<&Report> for Refusal {
    fn from(report: &Report) -> Self {
        let mut refusal = Self::new(422, "unsound", "the case is not valid");
        refusal.error.diagnostics = diagnostic::of_report(report);
        refusal
    }
}

impl From<Report> for Refusal {
    fn from(report: Report) -> Self {
        Self::from(&report)
    }
}

/// Errors of the engine.
impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        match error {
            Error::BadInput(message) => Self::bad_input(message),
            Error::Results(error) if error.is_of_reading() => Self::bad_input(error.to_string()),
            error => Self::failed(error),
        }
    }
}
