//! What is answered where something cannot be.

use std::fmt::Display;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::Report;
use wholestring_runner::Error;

use crate::diagnostic::{self, Diagnostic};

/// A request that is not answered as it was meant: `{"error": {...}}`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Refusal {
    /// The status that HTTP has for it.
    #[serde(skip)]
    pub status: u16,
    /// Why.
    pub error: ErrorDetails,
}

/// Why.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ErrorDetails {
    /// A word for programs.
    pub kind: &'static str,
    /// A sentence for people.
    pub message: String,
    /// What is wrong with the case, where that is it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub diagnostics: Vec<Diagnostic>,
}

impl Refusal {
    /// An answer with this status.
    pub fn new(status: u16, kind: &'static str, message: impl Into<String>) -> Self {
        let error = ErrorDetails { kind, message: message.into(), diagnostics: Vec::new() };
        Self { status, error }
    }

    /// There is no such thing.
    pub fn not_found(message: impl Into<String>) -> Self {
        Self::new(404, "not_found", message)
    }

    /// What was asked cannot be so.
    pub fn bad_input(message: impl Into<String>) -> Self {
        Self::new(422, "bad_input", message)
    }

    /// It should have gone, and did not: a full disk, for one.
    pub fn failed(error: impl Display) -> Self {
        Self::new(500, "failed", error.to_string())
    }
}

/// A case that is invalid.
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

/// What the engine does not do.
impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        match error {
            Error::BadInput(message) => Self::bad_input(message),
            error => Self::failed(error),
        }
    }
}
