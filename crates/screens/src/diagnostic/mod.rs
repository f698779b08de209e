//! Diagnostics of a case, with their places.

mod keys;
mod place;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::{Report, Severity};

use keys::Keys;
use place::Place;

/// A sentence about a place of a text.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct Diagnostic {
    /// `error`: the case cannot be used; `warning`: probably a mistake; `note`: how it was
    /// interpreted.
    pub level: Level,
    /// The mistake, in one sentence without a full stop.
    pub message: String,
    /// Text next to the place.
    pub label: String,
    /// The expected form, the nearest valid name, advice for the correction.
    pub help: Vec<String>,
    /// The dotted key at the place, such as `well.hole.0.friction`.
    pub key: Option<String>,
    /// The file of the place; null for the case.
    pub file: Option<String>,
    /// Its start, in UTF-16 units of the text.
    pub start: Option<usize>,
    /// One past its end.
    pub end: Option<usize>,
    /// Its line, from 1.
    pub line: Option<usize>,
    /// Its column, from 1, in UTF-16 units.
    pub column: Option<usize>,
}

/// Severity of a diagnostic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// The case cannot be used.
    Error,
    /// The case can be used, but is probably mistaken.
    Warning,
    /// Note on the interpretation.
    Note,
}

impl From<Severity> for Level {
    fn from(severity: Severity) -> Self {
        match severity {
            Severity::Error => Self::Error,
            Severity::Warning => Self::Warning,
        }
    }
}

impl Diagnostic {
    /// A diagnostic without a place.
    pub fn sentence(message: &str) -> Self {
        Self {
            level: Level::Error,
            message: message.to_owned(),
            label: String::new(),
            help: Vec::new(),
            key: None,
            file: None,
            start: None,
            end: None,
            line: None,
            column: None,
        }
    }
}

/// The diagnostics of a report. Its first source is the case.
pub fn of_report(report: &Report) -> Vec<Diagnostic> {
    let keys = report.sources.first().map(|case| Keys::of(&case.text)).unwrap_or_default();
    report.diagnostics.iter().map(|one| of(one, report, &keys)).collect()
}

fn of(one: &wholestring_case::Diagnostic, report: &Report, keys: &Keys) -> Diagnostic {
    let diagnostic = Diagnostic {
        level: one.severity.into(),
        help: one.help.clone(),
        // For a mistake in another file, the place of the case that names it.
        key: one
            .labels
            .iter()
            .find(|label| label.place.source == 0)
            .and_then(|label| keys.at(label.place.start)),
        ..Diagnostic::sentence(&one.message)
    };
    let Some(first) = one.labels.first() else {
        return diagnostic;
    };
    let label = first.text.clone();
    let Some(source) = report.sources.get(first.place.source) else {
        return Diagnostic { label, ..diagnostic };
    };
    let place = Place::of(&source.text, first.place.start, first.place.end);
    Diagnostic {
        label,
        file: (first.place.source > 0).then(|| source.name.clone()),
        start: Some(place.start),
        end: Some(place.end),
        line: Some(place.line),
        column: Some(place.column),
        ..diagnostic
    }
}
