//! What is wrong with a case, and where.

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
    /// `error`: the case cannot be used; `warning`: it hardly says what was meant; `note`: how it
    /// was understood.
    pub level: Level,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// What stands beside the place.
    pub label: String,
    /// What was expected, the nearest right name, how to put it right.
    pub help: Vec<String>,
    /// The dotted key that the place belongs to, such as `well.hole.0.friction`.
    pub key: Option<String>,
    /// The file that the place is in; null where it is the case.
    pub file: Option<String>,
    /// Where it begins, in UTF-16 units of the text.
    pub start: Option<usize>,
    /// One past its end.
    pub end: Option<usize>,
    /// Its line, from 1.
    pub line: Option<usize>,
    /// Its column, from 1, in UTF-16 units.
    pub column: Option<usize>,
}

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// The case cannot be used.
    Error,
    /// The case can be used, but probably does not say what was meant.
    Warning,
    /// How something was understood.
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
    /// One without a place.
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

/// What a report says. Its first source is the case.
pub fn of_report(report: &Report) -> Vec<Diagnostic> {
    let keys = report.sources.first().map(|case| Keys::of(&case.text)).unwrap_or_default();
    report.diagnostics.iter().map(|one| of(one, report, &keys)).collect()
}

fn of(one: &wholestring_case::Diagnostic, report: &Report, keys: &Keys) -> Diagnostic {
    let said = Diagnostic {
        level: one.severity.into(),
        help: one.help.clone(),
        // Where the mistake is in another file, the place of the case that names it.
        key: one
            .labels
            .iter()
            .find(|label| label.place.source == 0)
            .and_then(|label| keys.at(label.place.start)),
        ..Diagnostic::sentence(&one.message)
    };
    let Some(first) = one.labels.first() else {
        return said;
    };
    let label = first.text.clone();
    let Some(source) = report.sources.get(first.place.source) else {
        return Diagnostic { label, ..said };
    };
    let place = Place::of(&source.text, first.place.start, first.place.end);
    Diagnostic {
        label,
        file: (first.place.source > 0).then(|| source.name.clone()),
        start: Some(place.start),
        end: Some(place.end),
        line: Some(place.line),
        column: Some(place.column),
        ..said
    }
}
