//! Diagnostics: the mistake, its place, and the expected form.

use std::fmt;

use annotate_snippets::{
    Annotation, AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet,
};

use crate::source::{Source, Span};

/// Severity of a diagnostic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The case cannot be used.
    Error,
    /// The case can be used, but is probably mistaken.
    Warning,
}

/// An underlined place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The underlined text.
    pub place: Span,
    /// Text next to the underline; may be empty.
    pub text: String,
}

/// A diagnostic.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its severity.
    pub severity: Severity,
    /// The mistake, in one sentence without a full stop.
    pub message: String,
    /// The places concerned; the first is the mistake itself.
    pub labels: Vec<Label>,
    /// The expected form, the nearest valid name, advice for the correction: one line each.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// An error.
    pub fn error(message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            message: message.into(),
            labels: Vec::new(),
            help: Vec::new(),
        }
    }

    /// A warning about a usable but probably unintended value.
    pub fn warning(message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(message) }
    }

    /// A valid key that has no effect at its place; `why` is the text next to the place.
    pub fn idle(key: &str, place: Span, why: impl Into<String>) -> Self {
        Self::warning(format!("`{key}` has no effect here")).at(place, why)
    }

    /// Underlines the chosen word, or names the default if none is given.
    pub fn chosen(self, what: &str, chosen: Option<Span>, default: &str) -> Self {
        match chosen {
            Some(place) => self.at(place, what),
            None => self.help(format!("{what} is \"{default}\" by default")),
        }
    }

    /// Underlines a place; `text` is written next to the line.
    pub fn at(mut self, place: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { place, text: text.into() });
        self
    }

    /// Adds a line of help.
    pub fn help(mut self, line: impl Into<String>) -> Self {
        self.help.push(line.into());
        self
    }
}

/// Diagnostics with the texts that they refer to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Report {
    /// The case file, followed by the other files.
    pub sources: Vec<Source>,
    /// In the order of their places; at most a hundred.
    pub diagnostics: Vec<Diagnostic>,
}

/// Maximum number of diagnostics shown in full.
const SHOWN: usize = 20;

impl Report {
    /// A report about a file that could not be read at all.
    pub fn about_file(name: &str, diagnostic: Diagnostic) -> Self {
        Self {
            sources: vec![Source { name: name.to_owned(), text: String::new() }],
            diagnostics: vec![diagnostic],
        }
    }

    /// Whether it has no diagnostics.
    pub fn is_empty(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// Number of errors among the diagnostics.
    pub fn errors(&self) -> usize {
        self.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error).count()
    }

    /// The text for a person: each diagnostic with its place underlined, the first twenty in full.
    /// With `color`, ANSI escapes for a terminal.
    pub fn render(&self, color: bool) -> String {
        let renderer = if color { Renderer::styled() } else { Renderer::plain() };
        let mut text = String::new();
        for diagnostic in self.diagnostics.iter().take(SHOWN) {
            text.push_str(&renderer.render(&[self.group(diagnostic)]));
            text.push_str("\n\n");
        }
        let left = self.diagnostics.len().saturating_sub(SHOWN);
        if left > 0 {
            text.push_str(&format!("and {left} more\n"));
        } else {
            text.truncate(text.trim_end().len());
            if !text.is_empty() {
                text.push('\n');
            }
        }
        text
    }

    fn group<'a>(&'a self, diagnostic: &'a Diagnostic) -> Group<'a> {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group =
            level.primary_title(&diagnostic.message).elements(self.snippets(diagnostic));
        for line in &diagnostic.help {
            group = group.element(Level::HELP.message(line));
        }
        group
    }

    /// One snippet per source, the source of the first label first.
    fn snippets<'a>(&'a self, diagnostic: &'a Diagnostic) -> Vec<Element<'a>> {
        let mut order: Vec<usize> = Vec::new();
        for label in &diagnostic.labels {
            if !order.contains(&label.place.source) {
                order.push(label.place.source);
            }
        }
        if order.is_empty() {
            let case = self.sources.first();
            return case
                .map(|source| Element::from(Origin::path(&source.name)))
                .into_iter()
                .collect();
        }
        let mut elements = Vec::new();
        for index in order {
            let Some(source) = self.sources.get(index) else {
                continue;
            };
            let mut snippet: Snippet<'a, Annotation<'a>> =
                Snippet::source(&source.text).path(&source.name);
            for (i, label) in diagnostic.labels.iter().enumerate() {
                if label.place.source != index {
                    continue;
                }
                let kind = if i == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
                let mut annotation = kind.span(span_within(&source.text, label.place));
                if !label.text.is_empty() {
                    annotation = annotation.label(&label.text);
                }
                snippet = snippet.annotation(annotation);
            }
            elements.push(Element::from(snippet));
        }
        elements
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Report {}

/// The place as a range at character boundaries, on one line.
fn span_within(text: &str, place: Span) -> std::ops::Range<usize> {
    let mut start = place.start.min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let mut end = place.end.clamp(start, text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    if let Some(line) = text[start..end].find(['\n', '\r'])
        && line > 0
    {
        end = start + line;
    }
    start..end
}
