//! The case file as a tree in which every key and value has its place.

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

/// A value with its place.
#[derive(Debug, Clone)]
pub struct Node {
    /// Its place.
    pub place: Span,
    /// The value.
    pub value: Value,
}

/// A TOML value.
#[derive(Debug, Clone)]
pub enum Value {
    /// Text in quotes.
    Text {
        /// The text, without its quotes.
        text: String,
        /// Place of its first character in the source, if it is written without escapes.
        verbatim_from: Option<usize>,
    },
    /// A number.
    Number {
        /// Its value.
        value: f64,
        /// The integer, if it was written without point or exponent.
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
    /// The kind of value, for messages.
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

/// A key with its place.
#[derive(Debug, Clone)]
pub struct Key {
    /// Its name.
    pub name: String,
    /// Its place.
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

/// Reads a whole TOML text; returns the syntax errors with their places if there are any.
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
        // Mistakes after a broken line may only be its consequence.
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

/// Refuses nesting too deep for the parser.
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

/// The parser's message, reworded for users who have not read the TOML specification.
fn syntax_error(error: &toml::de::Error, text: &str, source: usize, offset: usize) -> Diagnostic {
    let span = error.span().unwrap_or(0..0);
    let place = Span { source, start: span.start + offset, end: span.end + offset };
    let message = error.message();
    let found = text.get(span.clone()).unwrap_or_default().trim();
    if message == "duplicate key" {
        let line_start = text[..span.start].rfind('\n').map_or(0, |end| end + 1);
        let help = if text[line_start..].trim_start().starts_with("[[") {
            "for a table that may occur several times, use double brackets"
        } else {
            "keep one of the two"
        };
        return Diagnostic::error(format!("`{}` is given twice", short(found)))
            .at(place, "it is already defined above")
            .help(help);
    }
    if let Some(written) = text_with_backslash(text, span.start) {
        return Diagnostic::error("a backslash in double quotes begins an escape")
            .at(place, message)
            .help(in_single_quotes(written));
    }
    if let Some((written, help)) = foot_or_inch_mark(text, span.start) {
        return Diagnostic::error(format!(
            "`{}` is a quantity, which needs quotes",
            short(written)
        ))
        .at(place, "a foot or inch mark is a quotation mark to TOML")
        .help(help);
    }
    if let Some(written) = parted_thousands(text, span.start) {
        return Diagnostic::error(format!("`{}` is not a number of TOML", short(written)))
            .at(place, message)
            .help(format!(
                "write {}, or in quotes with its unit: \"{} ft\"",
                written.replace(',', "_"),
                short(written)
            ));
    }
    if let Some((written, help)) = number_otherwise(text, span.start) {
        return Diagnostic::error(format!("`{}` is not a number of TOML", short(written)))
            .at(place, "expected a number, or text in quotes")
            .help(help);
    }
    if let Some(written) = typographic(text, span.start) {
        let plain = written.trim_matches(TYPOGRAPHIC);
        return Diagnostic::error("typographic quotes do not quote a text in TOML")
            .at(place, "expected straight quotes")
            .help(format!("write \"{}\"", short(plain)));
    }
    let diagnostic = Diagnostic::error("this is not TOML").at(place, message);
    if not_quoted(error) {
        if found.is_empty() {
            return Diagnostic::error("a value is missing after `=`").at(place, "expected a value");
        }
        return Diagnostic::error("text and quantities with a unit need quotes")
            .at(place, "not in quotes")
            .help(format!("write \"{}\"", short(found)));
    }
    diagnostic
}

/// The value of the line at a place of the text, without its comment.
fn value_of_line(text: &str, at: usize) -> Option<&str> {
    let line_start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let (_, value) = text[line_start..].lines().next()?.split_once('=')?;
    Some(value.split('#').next()?.trim())
}

/// A number as people write it and TOML does not, and how it is written: `0,2`, `.2`, `2.`,
/// `8-1/2`, `5 1/2`.
fn number_otherwise(text: &str, at: usize) -> Option<(&str, String)> {
    let written = value_of_line(text, at)?;
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = written.trim_start_matches(['+', '-']);
    let sign = &written[..written.len() - unsigned.len()];
    let help = if let Some((whole, rest)) = unsigned.split_once(',') {
        (digits(whole) && digits(rest)).then(|| format!("write {sign}{whole}.{rest}"))
    } else if let Some((whole, rest)) = unsigned.split_once('.') {
        match (digits(whole), digits(rest)) {
            (false, true) if whole.is_empty() => Some(format!("write {sign}0.{rest}")),
            (true, false) if rest.is_empty() => Some(format!("write {sign}{whole}.0")),
            _ => None,
        }
    } else {
        let (head, below) = unsigned.split_once('/')?;
        let parts: Vec<&str> = head.split(['-', ' ']).filter(|part| !part.is_empty()).collect();
        let is_fraction = digits(below) && matches!(parts.len(), 1 | 2);
        (is_fraction && parts.into_iter().all(digits))
            .then(|| format!("write it in quotes with its unit, such as \"{written} in\""))
    };
    Some((written, help?))
}

/// A length with a foot or inch mark as the value of a line, `8.5"` with double quotes or without,
/// and its correct notation.
fn foot_or_inch_mark(text: &str, at: usize) -> Option<(&str, String)> {
    let value = value_of_line(text, at)?;
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

/// Quotation marks of typesetting, which word processors write in place of straight ones.
const TYPOGRAPHIC: [char; 6] = ['“', '”', '„', '‘', '’', '‚'];

/// The value of a line that begins with a typographic quotation mark.
fn typographic(text: &str, at: usize) -> Option<&str> {
    let value = value_of_line(text, at)?;
    value.starts_with(TYPOGRAPHIC).then_some(value)
}

/// A number as the value of a line whose thousands are separated by commas.
fn parted_thousands(text: &str, at: usize) -> Option<&str> {
    let value = value_of_line(text, at)?;
    let mut groups = value.split(',');
    let is_number = |group: &str| !group.is_empty() && group.bytes().all(|b| b.is_ascii_digit());
    let first = groups.next().is_some_and(|group| is_number(group) && group.len() <= 3);
    let others = value.contains(',') && groups.all(|group| is_number(group) && group.len() == 3);
    (first && others).then_some(value)
}

/// The text in the double quotes around a place of a line, if it contains a backslash.
fn text_with_backslash(text: &str, at: usize) -> Option<&str> {
    let line_start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[line_start..].lines().next()?;
    let at = at - line_start;
    // Quotes alternately open and close; in single ones a backslash has no special meaning.
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

/// The notation of a path with backslashes.
pub fn in_single_quotes(path: &str) -> String {
    format!(
        "a path in single quotes is taken literally: '{}'; forward slashes work as well",
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
                // An integer too large for 64 bits is outside every range, which infinity
                // represents.
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
