//! Diagnostics of a case, with their places.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::{Report, Severity};
use wholestring_config::node::{Entries, Node, Value, parse_text};

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

// Places in an editor's UTF-16 units.

/// A stretch of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    /// Its start.
    start: usize,
    /// One past its end.
    end: usize,
    /// Its line, from 1.
    line: usize,
    /// Its column, from 1.
    column: usize,
}

impl Place {
    /// The place of a stretch of bytes, cut to the text and to whole characters.
    fn of(text: &str, start: usize, end: usize) -> Self {
        let boundary = |mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = boundary(start.min(text.len()));
        let end = boundary(end.clamp(start, text.len()));
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let units = |text: &str| text.chars().map(char::len_utf16).sum::<usize>();
        Self {
            start: units(before),
            end: units(&text[..end]),
            line: before.matches('\n').count() + 1,
            column: units(&before[line_start..]) + 1,
        }
    }
}

// The key at a place of a case.

/// The dotted keys of a text, by their first byte.
#[derive(Debug, Default)]
struct Keys(Vec<(usize, String)>);

impl Keys {
    /// The keys of a text; empty if it is not TOML.
    fn of(text: &str) -> Self {
        let mut keys = Self::default();
        if let Ok(entries) = parse_text(text, 0) {
            keys.table(&entries, "");
        }
        // The sort is stable, so that of keys with the same start the last stays the innermost.
        keys.0.sort_by_key(|(start, _)| *start);
        keys
    }

    /// The key at a byte of the text: the last one that begins at or before it.
    fn at(&self, byte: usize) -> Option<String> {
        let after = self.0.partition_point(|(start, _)| *start <= byte);
        self.0[..after].last().map(|(_, key)| key.clone())
    }

    fn table(&mut self, entries: &Entries, before: &str) {
        for (key, node) in &entries.0 {
            let dotted = match before {
                "" => key.name.clone(),
                before => format!("{before}.{}", key.name),
            };
            self.0.push((key.place.start, dotted.clone()));
            self.node(node, &dotted);
        }
    }

    fn node(&mut self, node: &Node, dotted: &str) {
        match &node.value {
            Value::Table(entries) => self.table(entries, dotted),
            Value::List(items) => {
                for (index, item) in items.iter().enumerate() {
                    let dotted = format!("{dotted}.{index}");
                    self.0.push((item.place.start, dotted.clone()));
                    self.node(item, &dotted);
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Keys, Place};

    #[test]
    fn letters_beyond_the_first_plane_are_two() {
        let text = "a = \"ä𝄞\"\nb = 1\n";
        let b = text.find('b').unwrap();
        assert_eq!(Place::of(text, b, b + 1), Place { start: 10, end: 11, line: 2, column: 1 });
        let note = text.find('𝄞').unwrap();
        assert_eq!(Place::of(text, note, b), Place { start: 6, end: 10, line: 1, column: 7 });
        // In the middle of a letter, and beyond the end.
        assert_eq!(Place::of(text, note + 1, note + 2).start, 6);
        assert_eq!(Place::of("", 5, 9), Place { start: 0, end: 0, line: 1, column: 1 });
    }

    #[test]
    fn a_place_belongs_to_the_innermost_key() {
        let text = "name = \"a\"\n[well]\nstations = [[0, 1], [2, 3]]\n[[well.hole]]\n\
                    kind = \"open\"\nfriction = { kinetic = 0.2, around = 7 }\n[[string]]\n\
                    od = 1\n[[string]]\nid = 2\n[mud]\n";
        let keys = Keys::of(text);
        let at = |what: &str| keys.at(text.find(what).unwrap()).unwrap();
        assert_eq!(at("\"a\""), "name");
        assert_eq!(at("3]"), "well.stations.1.1");
        assert_eq!(at("[2"), "well.stations.1");
        assert_eq!(at("[[well.hole]]"), "well.hole.0");
        assert_eq!(at("\"open\""), "well.hole.0.kind");
        assert_eq!(at("7 }"), "well.hole.0.friction.around");
        assert_eq!(at("od"), "string.0.od");
        assert_eq!(at("2\n[mud"), "string.1.id");
        assert_eq!(at("mud"), "mud");
        assert_eq!(Keys::of("name = ").at(3), None);
    }
}
