//! The case file as a tree in which every key and value knows its place.

use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

use wholestring_units::Dimension;

use crate::{
    diagnostic::Diagnostic,
    names::short,
    nesting::{MAX_DEPTH, too_deep},
    source::Span,
};

/// A value and where it stands.
#[derive(Debug, Clone)]
pub struct Node {
    /// Where it stands.
    pub place: Span,
    /// What it is.
    pub value: Value,
}

/// A value as TOML has them.
#[derive(Debug, Clone)]
pub enum Value {
    /// Text in quotes.
    Text {
        /// The text, without its quotes.
        text: String,
        /// Where its first character stands in the source, if it stands there as it is.
        verbatim_from: Option<usize>,
    },
    /// A number.
    Number {
        /// Its value.
        value: f64,
        /// Set where it was written without point or exponent.
        whole: Option<i64>,
    },
    /// True or false.
    Boolean(bool),
    /// A date or a time.
    Date,
    /// A list.
    List(Vec<Node>),
    /// A table.
    Table(Entries),
}

impl Value {
    /// What it is, in a user's words.
    pub fn noun(&self) -> &'static str {
        match self {
            Self::Text { .. } => "text",
            Self::Number { .. } => "a number",
            Self::Boolean(_) => "true or false",
            Self::Date => "a date",
            Self::List(_) => "a list",
            Self::Table(_) => "a table",
        }
    }
}

/// The keys of a table in the order of the file.
#[derive(Debug, Clone, Default)]
pub struct Entries(pub Vec<(Key, Node)>);

/// A key and where it stands.
#[derive(Debug, Clone)]
pub struct Key {
    /// What it is called.
    pub name: String,
    /// Where it stands.
    pub place: Span,
}

impl Entries {
    /// The value of a key.
    pub fn get(&self, name: &str) -> Option<&Node> {
        let found = self.0.iter().find(|(key, _)| key.name == name);
        found.map(|(_, node)| node)
    }

    /// The value of a key, to change it.
    pub fn get_mut(&mut self, name: &str) -> Option<&mut Node> {
        let found = self.0.iter_mut().find(|(key, _)| key.name == name);
        found.map(|(_, node)| node)
    }
}

/// Reads a whole TOML text; on mistakes of syntax, what they are and where.
pub fn parse_text(text: &str, source: usize) -> Result<Entries, Vec<Diagnostic>> {
    shallow(text, source, 0).map_err(|mistake| vec![mistake])?;
    let (table, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Ok(entries(table.get_ref(), text, source, 0));
    }
    let mut diagnostics = Vec::new();
    for error in &errors {
        let understood = error.message() == "duplicate key" || not_quoted(error);
        diagnostics.push(syntax_error(error, text, source, 0));
        // What comes after a broken line may only be its consequence.
        if !understood {
            break;
        }
    }
    Err(diagnostics)
}

fn not_quoted(error: &toml::de::Error) -> bool {
    error.message().starts_with("string values must be quoted")
}

/// Reads one TOML value that begins `offset` bytes into its source.
pub fn parse_value(text: &str, source: usize, offset: usize) -> Result<Node, Diagnostic> {
    shallow(text, source, offset)?;
    match DeValue::parse(text) {
        Ok(value) => Ok(node(&value, text, source, offset)),
        Err(error) => Err(syntax_error(&error, text, source, offset)),
    }
}

/// Refuses what is nested too deep for the parser.
fn shallow(text: &str, source: usize, offset: usize) -> Result<(), Diagnostic> {
    let Some(bracket) = too_deep(text) else {
        return Ok(());
    };
    let place = Span { source, start: bracket.start + offset, end: bracket.end + offset };
    let message = format!("more than {MAX_DEPTH} brackets are open here");
    Err(Diagnostic::error(message)
        .at(place, "expected that some are closed before")
        .help("a bracket is closed by one of its kind: { by }, [ by ]"))
}

/// What the parser says, in the words of somebody who has not read the TOML specification.
fn syntax_error(error: &toml::de::Error, text: &str, source: usize, offset: usize) -> Diagnostic {
    let span = error.span().unwrap_or(0..0);
    let place = Span { source, start: span.start + offset, end: span.end + offset };
    let said = error.message();
    let found = text.get(span.clone()).unwrap_or_default().trim();
    if said == "duplicate key" {
        let line_start = text[..span.start].rfind('\n').map_or(0, |end| end + 1);
        let help = if text[line_start..].trim_start().starts_with("[[") {
            "where there may be several, each is headed by double brackets"
        } else {
            "keep one of the two"
        };
        return Diagnostic::error(format!("`{}` is given twice", short(found)))
            .at(place, "it stands above already")
            .help(help);
    }
    if let Some(written) = text_with_backslash(text, span.start) {
        return Diagnostic::error("a backslash in double quotes begins an escape")
            .at(place, said)
            .help(in_single_quotes(written));
    }
    if let Some((written, help)) = foot_or_inch_mark(text, span.start) {
        return Diagnostic::error(format!(
            "`{}` is a quantity and stands in quotes",
            short(written)
        ))
        .at(place, "a foot or inch mark is a quotation mark to TOML")
        .help(help);
    }
    if let Some(written) = parted_thousands(text, span.start) {
        return Diagnostic::error(format!("`{}` is not a number of TOML", short(written)))
            .at(place, said)
            .help(format!(
                "write {}, or in quotes with its unit: \"{} ft\"",
                written.replace(',', "_"),
                short(written)
            ));
    }
    let diagnostic = Diagnostic::error("this is not TOML").at(place, said);
    if not_quoted(error) {
        if found.is_empty() {
            return Diagnostic::error("a value is missing after `=`").at(place, "expected a value");
        }
        return Diagnostic::error("text and quantities with a unit stand in quotes")
            .at(place, "not in quotes")
            .help(format!("write \"{}\"", short(found)));
    }
    diagnostic
}

/// A length with a foot or inch mark as the value of a line, `8.5"` in double quotes or in none, and how
/// it is written.
fn foot_or_inch_mark(text: &str, at: usize) -> Option<(&str, String)> {
    let line_start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let (_, value) = text[line_start..].lines().next()?.split_once('=')?;
    let value = value.split('#').next()?.trim();
    let within = value.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    let written = within.into_iter().chain([value]).find(|written| {
        written.ends_with(['"', '\'']) && Dimension::Diameter.read(written).is_ok()
    })?;
    let number = written.trim_end_matches(['"', '\'']).trim();
    let is_inch = written.ends_with('"') || written.ends_with("''");
    let help = match (is_inch, number.contains('\'')) {
        (true, false) => format!("write \"{number} in\", or '{number}\"' in single quotes"),
        (true, true) => format!("write \"{}\"", written.replace('"', "\\\"")),
        (false, _) => format!("write \"{number} ft\""),
    };
    Some((written, help))
}

/// A number as the value of a line whose thousands are parted by commas.
fn parted_thousands(text: &str, at: usize) -> Option<&str> {
    let line_start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let (_, value) = text[line_start..].lines().next()?.split_once('=')?;
    let value = value.split('#').next()?.trim();
    let mut groups = value.split(',');
    let is_number = |group: &str| !group.is_empty() && group.bytes().all(|b| b.is_ascii_digit());
    let first = groups.next().is_some_and(|group| is_number(group) && group.len() <= 3);
    let others = value.contains(',') && groups.all(|group| is_number(group) && group.len() == 3);
    (first && others).then_some(value)
}

/// What stands in the double quotes around a place of a line, if a backslash is in it.
fn text_with_backslash(text: &str, at: usize) -> Option<&str> {
    let line_start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[line_start..].lines().next()?;
    let at = at - line_start;
    // Quotes by turns open and close; in single ones a backslash is only that.
    let (mut open, mut single) = (None, false);
    for (place, letter) in line.char_indices() {
        match (letter, open) {
            ('\'', None) => single = !single,
            ('"', None) if !single => open = Some(place + 1),
            ('"', Some(start)) => {
                if place >= at {
                    return Some(&line[start..place]).filter(|inside| inside.contains('\\'));
                }
                open = None;
            }
            _ => {}
        }
    }
    None
}

/// How a path with backslashes is written.
pub fn in_single_quotes(path: &str) -> String {
    format!(
        "a path in single quotes is taken as it stands: '{}'; forward slashes do as well",
        short(path)
    )
}

fn entries(table: &DeTable<'_>, text: &str, source: usize, offset: usize) -> Entries {
    let mut entries: Vec<(Key, Node)> = table
        .iter()
        .map(|(key, value)| {
            let key = Key { name: key.get_ref().to_string(), place: place(key, source, offset) };
            (key, node(value, text, source, offset))
        })
        .collect();
    entries.sort_by_key(|(key, _)| key.place.start);
    Entries(entries)
}

fn node(value: &Spanned<DeValue<'_>>, text: &str, source: usize, offset: usize) -> Node {
    let span = value.span();
    let converted = match value.get_ref() {
        DeValue::String(content) => Value::Text {
            text: content.to_string(),
            verbatim_from: text
                .get(span.start + 1..(span.end.max(2) - 1).max(span.start + 1))
                .filter(|inside| *inside == content.as_ref())
                .map(|_| span.start + 1 + offset),
        },
        DeValue::Integer(integer) => {
            let whole = i64::from_str_radix(integer.as_str(), integer.radix()).ok();
            Value::Number {
                // A whole number too large for 64 bits is out of every range: infinity says so.
                value: whole.map_or(f64::INFINITY, |whole| whole as f64),
                whole,
            }
        }
        DeValue::Float(float) => {
            Value::Number { value: float.as_str().parse().unwrap_or(f64::NAN), whole: None }
        }
        DeValue::Boolean(truth) => Value::Boolean(*truth),
        DeValue::Datetime(_) => Value::Date,
        DeValue::Array(items) => {
            Value::List(items.iter().map(|item| node(item, text, source, offset)).collect())
        }
        DeValue::Table(table) => Value::Table(entries(table, text, source, offset)),
    };
    Node { place: place(value, source, offset), value: converted }
}

fn place<T>(spanned: &Spanned<T>, source: usize, offset: usize) -> Span {
    let span = spanned.span();
    Span { source, start: span.start + offset, end: span.end + offset }
}
