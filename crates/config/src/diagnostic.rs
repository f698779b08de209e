//! What is wrong, where, and what was expected.

use std::fmt;

use annotate_snippets::{
    Annotation, AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet,
};

use crate::source::{Source, Span};

/// Whether a case can be used in spite of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The case cannot be used.
    Error,
    /// The case can be used, but probably does not say what was meant.
    Warning,
}

/// An underlined place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// What is underlined.
    pub place: Span,
    /// What stands beside the underline; may be empty.
    pub text: String,
}

/// One mistake.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// The places concerned; the first is the mistake itself.
    pub labels: Vec<Label>,
    /// What was expected, the nearest right name, how to put it right: one line each.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// A mistake.
    pub fn error(message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            message: message.into(),
            labels: Vec::new(),
            help: Vec::new(),
        }
    }

    /// What can be used, but is hardly meant.
    pub fn warning(message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(message) }
    }

    /// A key that is valid and has no effect where it stands; `why` stands beside it.
    pub fn idle(key: &str, place: Span, why: impl Into<String>) -> Self {
        Self::warning(format!("`{key}` has no effect here")).at(place, why)
    }

    /// Underlines the word that was chosen, or says which one is taken where none is given.
    pub fn chosen(self, what: &str, chosen: Option<Span>, default: &str) -> Self {
        match chosen {
            Some(place) => self.at(place, what),
            None => self.help(format!("{what} is \"{default}\" where none is given")),
        }
    }

    /// Underlines a place; `text` stands beside the line.
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

/// Diagnostics together with the texts that they point into.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Report {
    /// The case file first, then what else was read.
    pub sources: Vec<Source>,
    /// In the order of their places; at most a hundred.
    pub diagnostics: Vec<Diagnostic>,
}

/// More than a person reads at once.
const SHOWN: usize = 20;

impl Report {
    /// A report about a file that could not be read at all.
    pub fn about_file(name: &str, diagnostic: Diagnostic) -> Self {
        Self {
            sources: vec![Source { name: name.to_owned(), text: String::new() }],
            diagnostics: vec![diagnostic],
        }
    }

    /// Whether there is nothing to say.
    pub fn is_empty(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// How many of the diagnostics are errors.
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

/// The place as a range that the text can be cut at, on one line.
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
