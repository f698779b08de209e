//! One thing that an engineer must know.

use serde::{Deserialize, Serialize};

use super::Kind;

/// How grave a finding is. Worse ones are greater.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Level {
    /// To be known when the answer is read.
    Note,
    /// A limit is near or passed, or a number is less certain than it looks.
    Warning,
    /// The operation cannot be carried out so, or the answer must not be used.
    Error,
}

impl Level {
    /// Name in results and on the screen.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// One thing that an engineer must know about a result, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finding {
    /// What was found.
    pub kind: Kind,
    /// How grave it is.
    pub level: Level,
    /// Measured depth at which it stands, or at which its interval begins, m; none where it has no
    /// place.
    pub from_md_m: Option<f64>,
    /// Measured depth at which its interval ends, m; none where it is a point or has no place.
    pub to_md_m: Option<f64>,
    /// What was found, in the kind's unit; none where it is no number.
    pub value: Option<f64>,
    /// What it is compared with, in the same unit; none where there is no such number.
    pub limit: Option<f64>,
}

impl Finding {
    /// A finding without place or number.
    pub(super) fn new(kind: Kind, level: Level) -> Self {
        Self { kind, level, from_md_m: None, to_md_m: None, value: None, limit: None }
    }

    /// The same with its number.
    pub(super) fn value(self, value: f64) -> Self {
        Self { value: Some(value), ..self }
    }

    /// The same with what the number is compared with.
    pub(super) fn limit(self, limit: f64) -> Self {
        Self { limit: Some(limit), ..self }
    }

    /// The same at a measured depth, m.
    pub(super) fn at(self, md_m: f64) -> Self {
        Self { from_md_m: Some(md_m.max(0.0)), ..self }
    }

    /// The same over an interval of measured depth, m.
    pub(super) fn over(self, [from_md_m, to_md_m]: [f64; 2]) -> Self {
        Self { from_md_m: Some(from_md_m.max(0.0)), to_md_m: Some(to_md_m.max(0.0)), ..self }
    }
}
