//! What is wrong with a case, and where.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::{Report, Severity};

/// A sentence about a place of a text.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct Diagnostic {
    /// `error`: the case cannot be used; `warning`: it hardly says what was meant; `note`: how it
    /// was understood.
    pub(crate) level: Level,
    /// What is wrong, in one sentence without a full stop.
    pub(crate) message: String,
    /// What stands beside the place.
    pub(crate) label: String,
    /// What was expected, the nearest right name, how to put it right.
    pub(crate) help: Vec<String>,
    /// The dotted key that the place belongs to, such as `well.hole.0.friction`.
    pub(crate) key: Option<String>,
    /// The file that the place is in; null where it is the case.
    pub(crate) file: Option<String>,
    /// Where it begins, in UTF-16 units of the text.
    pub(crate) start: Option<usize>,
    /// One past its end.
    pub(crate) end: Option<usize>,
    /// Its line, from 1.
    pub(crate) line: Option<usize>,
    /// Its column, from 1, in UTF-16 units.
    pub(crate) column: Option<usize>,
}

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Level {
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

/// What a report says. Its first source is the case.
pub(crate) fn of_report(report: &Report) -> Vec<Diagnostic> {
    let one = |of: &wholestring_case::Diagnostic| {
        let first = of.labels.first();
        let source = first.and_then(|label| report.sources.get(label.place.source));
        let place = first
            .zip(source)
            .map(|(label, source)| place::of(&source.text, label.place.start, label.place.end));
        let file = first.filter(|label| label.place.source > 0).and(source);
        Diagnostic {
            level: of.severity.into(),
            message: of.message.clone(),
            label: first.map(|label| label.text.clone()).unwrap_or_default(),
            help: of.help.clone(),
            key: None,
            file: file.map(|file| file.name.clone()),
            start: place.map(|place| place.start),
            end: place.map(|place| place.end),
            line: place.map(|place| place.line),
            column: place.map(|place| place.column),
        }
    };
    report.diagnostics.iter().map(one).collect()
}

mod place {
    /// A place as an editor counts: in UTF-16 units.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub(super) struct Place {
        pub(super) start: usize,
        pub(super) end: usize,
        pub(super) line: usize,
        pub(super) column: usize,
    }

    /// The place of a stretch of bytes, cut to the text and to whole characters.
    pub(super) fn of(text: &str, start: usize, end: usize) -> Place {
        let start = text.floor_char_boundary(start.min(text.len()));
        let end = text.ceil_char_boundary(end.clamp(start, text.len()));
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let units = |text: &str| text.chars().map(char::len_utf16).sum::<usize>();
        Place {
            start: units(before),
            end: units(&text[..end]),
            line: before.matches('\n').count() + 1,
            column: units(&before[line_start..]) + 1,
        }
    }
}
