//! Values set from the command line in place of the file's.

use std::{ops::Range, sync::Arc};

use wholestring_config::{
    node::{Key, parse_value},
    prelude::*,
    schema::{homes_of, top_level},
};

use crate::well::hole::MAX_FRICTION;

/// A `--set KEY=VALUE`.
///
/// The key is a dotted key of the case file, lists counted from zero (`well.hole.0.friction`), or
/// one of the short keys `friction` (every hole section; coefficients of static and rotational
/// friction keep their ratio to it), `bit_depth`, `rpm` and `wob`. The value is a TOML value if it
/// can be read as one (`0.3`, `[1, 2]`, `"drill"`), and text otherwise (`300m`, `drill`). A number
/// without a unit is refused where the key has a dimension, because a shell removes the quotes of
/// `"9.5 ppg"`.
///
/// ```
/// use wholestring_case::Override;
///
/// let depth: Override = "operation.bit_depth = 300m".parse()?;
/// assert_eq!((depth.key.as_str(), depth.value.as_str()), ("operation.bit_depth", "300m"));
/// assert!("bit_depth".parse::<Override>().is_err());
/// # Ok::<(), wholestring_case::OverrideError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Override {
    /// Dotted or short key.
    pub key: String,
    /// Value as written; empty where the key is removed.
    pub value: String,
    /// Whether the key is removed, so that its default applies.
    removes: bool,
    /// Source of the override, if it was not an argument of its own.
    quote: Option<Quote>,
}

/// Quotation of an override in diagnostics, and the parts of the quotation that are its key and
/// value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quote {
    /// Name of the text for the user.
    pub name: Arc<str>,
    /// The text.
    pub text: Arc<str>,
    /// Range of the key in the text, in bytes.
    pub key: Range<usize>,
    /// Range of the value in the text, in bytes.
    pub value: Range<usize>,
    /// Whether the text contains the value verbatim.
    pub verbatim: bool,
}

impl Quote {
    /// Returns the quotation `key = value`, with this name.
    pub fn of_value(name: &str, key: &str, value: &str) -> Self {
        let text = format!("{key} = {value}");
        let start = text.len() - value.len();
        Self {
            name: name.into(),
            key: 0..key.len(),
            value: start..text.len(),
            text: text.into(),
            verbatim: true,
        }
    }
}

impl Override {
    /// Returns an override with another source than its own `--set`.
    pub fn quoted(key: &str, value: &str, quote: Quote) -> Self {
        let (key, value) = (key.to_owned(), value.to_owned());
        Self { key, value, removes: false, quote: Some(quote) }
    }

    /// Returns an override that removes a key, so that its default applies; removing an item of a
    /// list is refused.
    pub fn removal(key: &str, quote: Quote) -> Self {
        let (key, value) = (key.to_owned(), String::new());
        Self { key, value, removes: true, quote: Some(quote) }
    }

    /// Returns the value without quotes.
    pub fn bare(&self) -> &str {
        self.value.trim_matches(['"', '\''])
    }

    /// Returns its quotation in diagnostics.
    fn quote(&self) -> Quote {
        self.quote.clone().unwrap_or_else(|| {
            let prefix = "--set ";
            let key = prefix.len()..prefix.len() + self.key.len();
            let value = key.end + 1..key.end + 1 + self.value.len();
            Quote {
                name: COMMAND_LINE.into(),
                text: format!("{prefix}{}={}", self.key, self.value).into(),
                key,
                value,
                verbatim: true,
            }
        })
    }
}

/// A text that is not `KEY=VALUE`.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{}` is not KEY=VALUE, such as operation.bit_depth=300m or friction=0.3", short(.0))]
pub struct OverrideError(pub String);

impl std::str::FromStr for Override {
    type Err = OverrideError;

    fn from_str(text: &str) -> Result<Self, OverrideError> {
        match text.split_once('=') {
            Some((key, value)) if !key.trim().is_empty() && !value.trim().is_empty() => {
                let (key, value) = (key.trim().to_owned(), value.trim().to_owned());
                Ok(Self { key, value, removes: false, quote: None })
            }
            _ => Err(OverrideError(text.to_owned())),
        }
    }
}

/// The short keys and the keys that they abbreviate.
pub(crate) const SHORT: &[(&str, &str)] = &[
    ("friction", "well.hole.*.friction"),
    ("bit_depth", "operation.bit_depth"),
    ("rpm", "operation.rpm"),
    ("wob", "operation.wob"),
];

/// Maximum number of parts of a key between its dots. The deepest key of a case has six; each is a
/// table within the previous one.
const MAX_PARTS: usize = 32;

/// Applies an override to the tree of the case.
pub(crate) fn apply(root: &mut Entries, change: &Override, reader: &mut Reader) {
    let quote = change.quote();
    let source = reader.add_source(&quote.name, &quote.text);
    let place = |range: Range<usize>| Span { source, start: range.start, end: range.end };
    let key_place = place(quote.key);
    if change.removes {
        if !remove(root, &parts(&change.key)) {
            let message = format!("the case has no `{}` that could be removed", short(&change.key));
            reader.report(Diagnostic::error(message).at(key_place, "expected a key of the case"));
        }
        return;
    }
    let mut node = match value_node(&change.value, source, quote.value.start) {
        Ok(node) => node,
        Err(diagnostic) => return reader.report(diagnostic),
    };
    // A value of a range has no quotes of its own either.
    let asks_unit = !quote.verbatim || *quote.name == *COMMAND_LINE;
    if !quote.verbatim {
        node.place = place(quote.value);
        if let Value::Text { verbatim_from, .. } = &mut node.value {
            *verbatim_from = None;
        }
    }
    if asks_unit {
        reader.ask_unit(&node);
    }
    put(root, &change.key, &node, key_place, reader);
}

/// Removes a key from the tree of the case and returns whether it existed. Items of lists are not
/// removed.
fn remove(table: &mut Entries, path: &[&str]) -> bool {
    match path {
        [] => false,
        [last] => {
            let before = table.0.len();
            table.0.retain(|(key, _)| key.name != *last);
            table.0.len() < before
        }
        [first, rest @ ..] => table.get_mut(first).is_some_and(|entry| remove_in(entry, rest)),
    }
}

fn remove_in(entry: &mut Node, path: &[&str]) -> bool {
    match (&mut entry.value, path) {
        (Value::Table(table), path) => remove(table, path),
        (Value::List(items), ["*", rest @ ..]) => {
            items.iter_mut().fold(false, |removed, item| remove_in(item, rest) | removed)
        }
        (Value::List(items), [first, rest @ ..]) => {
            let index = first.parse().ok();
            let item = index.and_then(|index: usize| items.get_mut(index));
            item.is_some_and(|item| remove_in(item, rest))
        }
        _ => false,
    }
}

/// Returns the long form of a key: `operation.wob` of `wob`.
///
/// ```
/// assert_eq!(wholestring_case::long_key("wob"), "operation.wob");
/// assert_eq!(wholestring_case::long_key("mud.density"), "mud.density");
/// ```
pub fn long_key(key: &str) -> &str {
    SHORT.iter().find(|(short, _)| *short == key).map_or(key, |(_, long)| long)
}

/// Returns the parts of a key between its dots, with a short key expanded.
fn parts(key: &str) -> Vec<&str> {
    long_key(key).split('.').collect()
}

/// Sets a value in the tree of the case at a dotted or short key.
pub(crate) fn put(
    root: &mut Entries,
    key: &str,
    node: &Node,
    key_place: Span,
    reader: &mut Reader,
) {
    let path = parts(key);
    if path.len() > MAX_PARTS {
        let message = format!("this key has {} parts", path.len());
        let diagnostic = Diagnostic::error(message)
            .at(key_place, format!("expected at most {MAX_PARTS}, parted by dots"));
        return reader.report(diagnostic);
    }
    let tables = reader.tables();
    let top_level = tables.map_or_else(Vec::new, top_level);
    if path.len() == 1 && !top_level.iter().any(|name| name == path[0]) {
        let short_keys: Vec<&str> = SHORT.iter().map(|(short, _)| *short).collect();
        let homes = tables.map_or_else(Vec::new, |tables| homes_of(tables, path[0]));
        let mut diagnostic = Diagnostic::error(format!("there is no key `{}`", short(path[0])))
            .at(key_place, "unknown key");
        if let Some(home) = homes.first() {
            let table = home.trim_matches(['[', ']']);
            diagnostic = diagnostic.help(format!("write {table}.{}", path[0]));
        } else if let Some(near) =
            nearest(path[0], short_keys.iter().copied().chain(top_level.iter().map(String::as_str)))
        {
            diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
        }
        return reader.report(diagnostic.help(format!(
            "keys are dotted, such as operation.bit_depth; short keys: {}",
            short_keys.join(", ")
        )));
    }
    if let Err(problem) = set_in_table(root, &path, node, key_place) {
        reader.report(Diagnostic::error(problem.message).at(key_place, problem.label));
    }
}

/// Returns the values in the tree of the case at a dotted or short key: none, one, or that of every
/// item of a list. For a table of friction coefficients it returns the kinetic one, because that is
/// the one that a number in its place sets.
pub(crate) fn standing<'a>(root: &'a Entries, key: &str) -> Vec<&'a Node> {
    let mut found = Vec::new();
    let path = parts(key);
    if let Some((first, rest)) = path.split_first()
        && let Some(node) = root.get(first)
    {
        gather(node, first, rest, &mut found);
    }
    found
}

fn gather<'a>(node: &'a Node, name: &str, path: &[&str], found: &mut Vec<&'a Node>) {
    let Some((first, rest)) = path.split_first() else {
        let kinetic = match &node.value {
            Value::Table(table) if name == "friction" => table.get("kinetic"),
            _ => None,
        };
        return found.push(kinetic.unwrap_or(node));
    };
    match &node.value {
        Value::List(items) if *first == "*" => {
            items.iter().for_each(|item| gather(item, name, rest, found));
        }
        Value::List(items) => {
            let item = first.parse().ok().and_then(|index: usize| items.get(index));
            if let Some(item) = item {
                gather(item, name, rest, found);
            }
        }
        Value::Table(table) => {
            if let Some(node) = table.get(first) {
                gather(node, first, rest, found);
            }
        }
        _ => {}
    }
}

/// Returns the value as TOML if it is valid TOML, as text otherwise.
fn value_node(text: &str, source: usize, offset: usize) -> Result<Node, Diagnostic> {
    match parse_value(text, source, offset) {
        Ok(node) => Ok(node),
        // A value that begins like TOML was meant as TOML.
        Err(diagnostic) if text.starts_with(['[', '{', '"', '\'']) => Err(diagnostic),
        Err(_) => Ok(Node {
            place: Span { source, start: offset, end: offset + text.len() },
            value: Value::Text { text: text.to_owned(), verbatim_from: Some(offset) },
        }),
    }
}

struct Problem {
    message: String,
    label: String,
}

fn set_in_table(
    table: &mut Entries,
    path: &[&str],
    node: &Node,
    key_place: Span,
) -> Result<(), Problem> {
    let Some((first, rest)) = path.split_first() else {
        return Ok(());
    };
    if first.is_empty() {
        return Err(Problem {
            message: "a key is empty between two dots".to_owned(),
            label: "expected a dotted key".to_owned(),
        });
    }
    if table.get(first).is_none() {
        if rest.first() == Some(&"*") {
            // The list is missing, which is reported when the case is read.
            return Ok(());
        }
        let key = Key { name: (*first).to_owned(), place: key_place };
        let fresh = Node { place: key_place, value: Value::Table(Entries::default()) };
        table.0.push((key, fresh));
    }
    match table.get_mut(first) {
        Some(entry) => set_in(entry, first, rest, node, key_place),
        None => Ok(()),
    }
}

/// Replaces the kinetic coefficient of a table of friction coefficients by a number; the others
/// keep their ratios to it. Returns whether the entry is such a table.
fn set_friction(entry: &mut Node, node: &Node) -> Result<bool, Problem> {
    let (Value::Table(table), Value::Number { value: new, .. }) = (&mut entry.value, &node.value)
    else {
        return Ok(false);
    };
    let Some(Value::Number { value: old, .. }) = table.get("kinetic").map(|old| old.value.clone())
    else {
        return Ok(false);
    };
    if old.is_nan() || old <= 0.0 {
        return Ok(false);
    }
    for (key, coefficient) in &mut table.0 {
        if key.name == "kinetic" {
            *coefficient = node.clone();
        } else if let Value::Number { value, whole } = &mut coefficient.value {
            let scaled = new * (*value / old);
            // A number that is not a valid coefficient is refused as such.
            if scaled > MAX_FRICTION && (0.0..=MAX_FRICTION).contains(new) {
                let name = &key.name;
                return Err(Problem {
                    message: format!(
                        "a friction of {new} makes `{name}` {scaled}, which is too large"
                    ),
                    label: format!(
                        "`{name}` keeps its ratio to `kinetic`, {} in the case; expected 0 to \
                         {MAX_FRICTION}",
                        *value / old
                    ),
                });
            }
            *value = scaled;
            *whole = None;
            coefficient.place = node.place;
        }
    }
    Ok(true)
}

fn set_in(
    entry: &mut Node,
    name: &str,
    path: &[&str],
    node: &Node,
    key_place: Span,
) -> Result<(), Problem> {
    let Some((first, rest)) = path.split_first() else {
        if !(name == "friction" && set_friction(entry, node)?) {
            *entry = node.clone();
        }
        return Ok(());
    };
    let noun = entry.value.noun();
    match &mut entry.value {
        Value::List(items) if *first == "*" => {
            items.iter_mut().try_for_each(|item| set_in(item, name, rest, node, key_place))
        }
        _ if *first == "*" => Ok(()),
        Value::Table(table) => set_in_table(table, path, node, key_place),
        Value::List(items) => {
            let count = items.len();
            let index: Option<usize> = first.parse().ok();
            match index.and_then(|index| items.get_mut(index)) {
                Some(item) => set_in(item, name, rest, node, key_place),
                None => Err(Problem {
                    message: format!("`{}` has no item `{}`", short(name), short(first)),
                    label: match count {
                        0 => "the list is empty".to_owned(),
                        _ => format!("expected a number from 0 to {}", count - 1),
                    },
                }),
            }
        }
        _ => Err(Problem {
            message: format!("`{}` is {noun} and has no keys", short(name)),
            label: format!("it has no `{}`", short(first)),
        }),
    }
}
