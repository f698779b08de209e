//! Rules of values: one rule reads a value, checks it and describes it in the schema.

use serde_json::{Value as Json, json};
use wholestring_units::number_text;

use crate::{
    diagnostic::Diagnostic,
    invisible::{described, invisible},
    names::{any_of, nearest, short},
    node::{Entries, Node, Value, in_single_quotes},
    reader::Reader,
    source::Span,
};

/// Reading and description of a value.
pub trait Rule {
    /// The type of the value.
    type Value;
    /// Reads a value; mistakes are added to the reader's diagnostics.
    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Self::Value>;
    /// The value if its key is missing in the file.
    fn absent(&self, _table: Span, _reader: &mut Reader) -> Option<Self::Value> {
        None
    }
    /// JSON schema of the value.
    fn schema(&self) -> Json;
    /// The heading of the table, if the value is one, for messages.
    fn heading(&self) -> Option<&'static str> {
        None
    }
    /// An example of the value, for messages.
    fn example(&self) -> Option<String> {
        None
    }
    /// A default in its usual notation.
    fn written(&self, default: &Json) -> String {
        match default.as_f64() {
            Some(number) => number_text(number),
            None => default.to_string(),
        }
    }
    /// The value as JSON for the defaults of the schema.
    fn json(&self, _value: &Self::Value) -> Json {
        Json::Null
    }
}

/// A non-empty text.
#[derive(Debug, Clone, Copy)]
pub struct Text;

impl Rule for Text {
    type Value = String;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<String> {
        let Value::Text { text, .. } = &node.value else {
            reader.expected(node, "text in quotes");
            return None;
        };
        let problem = if text.trim().is_empty() {
            "is empty".to_owned()
        } else if text.chars().any(char::is_control) {
            "holds a line break or another control character".to_owned()
        } else if let Some(letter) = invisible(text) {
            format!("holds {}", described(letter))
        } else if text.chars().count() > 200 {
            "is longer than 200 characters".to_owned()
        } else {
            return Some(text.clone());
        };
        let message = format!("`{}` {problem}", reader.key);
        let mut diagnostic = Diagnostic::error(message).at(node.place, "expected a short text");
        let written = reader.text_at(node.place).trim_matches('"');
        if written.contains('\\') {
            diagnostic = diagnostic.help(in_single_quotes(written));
        }
        diagnostic.refuse(reader)
    }

    fn schema(&self) -> Json {
        json!({ "type": "string", "minLength": 1, "maxLength": 200 })
    }
}

/// A text of several lines.
#[derive(Debug, Clone, Copy)]
pub struct Prose;

impl Rule for Prose {
    type Value = String;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<String> {
        const MAX: usize = 5000;
        let Value::Text { text, .. } = &node.value else {
            reader.expected(node, "text in quotes");
            return None;
        };
        let control = |letter: char| letter.is_control() && !letter.is_whitespace();
        let problem = if text.chars().any(control) {
            "holds a control character".to_owned()
        } else if text.chars().count() > MAX {
            format!("is longer than {MAX} characters")
        } else {
            return Some(text.trim().to_owned());
        };
        let message = format!("`{}` {problem}", reader.key);
        Diagnostic::error(message).at(node.place, "expected a text").refuse(reader)
    }

    fn schema(&self) -> Json {
        json!({ "type": "string", "maxLength": 5000 })
    }
}

/// One of a few words.
pub struct Choice<T: 'static> {
    /// The noun for messages.
    pub noun: &'static str,
    /// The words and their values.
    pub words: &'static [(&'static str, T)],
}

impl<T: Copy + PartialEq> Rule for Choice<T> {
    type Value = T;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<T> {
        let words: Vec<&str> = self.words.iter().map(|(word, _)| *word).collect();
        let expected = any_of(&words);
        let Value::Text { text, .. } = &node.value else {
            reader.expected(node, &expected);
            return None;
        };
        if let Some((_, meaning)) = self.words.iter().find(|(word, _)| word == text) {
            return Some(*meaning);
        }
        let mut diagnostic = Diagnostic::error(format!("`{}` is not {}", short(text), self.noun))
            .at(node.place, format!("expected {expected}"));
        if let Some(nearest) = nearest(text, words) {
            diagnostic = diagnostic.help(format!("did you mean \"{nearest}\"?"));
        }
        diagnostic.refuse(reader)
    }

    fn example(&self) -> Option<String> {
        self.words.first().map(|(word, _)| format!("\"{word}\""))
    }

    fn schema(&self) -> Json {
        let words: Vec<&str> = self.words.iter().map(|(word, _)| *word).collect();
        json!({ "type": "string", "enum": words })
    }

    fn json(&self, value: &T) -> Json {
        let word = self.words.iter().find(|(_, meaning)| meaning == value);
        word.map_or(Json::Null, |(word, _)| json!(word))
    }
}

/// A value with its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// The place.
    pub place: Span,
}

/// Refuses duplicates in a list.
pub fn once_each<T: Copy + PartialEq>(
    list: &[Spanned<T>],
    name: fn(T) -> &'static str,
    reader: &mut Reader,
) -> Option<()> {
    for (i, at) in list.iter().enumerate() {
        if let Some(first) = list[..i].iter().find(|first| first.value == at.value) {
            return Diagnostic::error(format!("`{}` is listed twice", name(at.value)))
                .at(at.place, "again here")
                .at(first.place, "first here")
                .refuse(reader);
        }
    }
    Some(())
}

/// The word of a value among those of a [`Choice`].
pub fn word_of<T: PartialEq>(words: &[(&'static str, T)], value: &T) -> &'static str {
    words.iter().find(|(_, one)| one == value).map_or("", |(word, _)| word)
}

/// A list, each item by the same rule.
pub struct List<R> {
    /// The rule of an item.
    pub item: R,
    /// Whether a single item may be written without brackets.
    pub or_one: bool,
    /// The noun of its items, for messages.
    pub noun: &'static str,
    /// Maximum number of items.
    pub most: usize,
}

impl<R> List<R> {
    /// A list of at most this many items, in brackets.
    pub const fn of(item: R, noun: &'static str, most: usize) -> Self {
        Self { item, or_one: false, noun, most }
    }

    /// A list of at most this many items; a single one may be written without brackets.
    pub const fn or_one(item: R, noun: &'static str, most: usize) -> Self {
        Self { item, or_one: true, noun, most }
    }
}

impl List<()> {
    /// A list of at most this many tables of one kind.
    pub const fn tables<T>(noun: &'static str, most: usize) -> List<Section<T>> {
        List::of(Section::<T>::RULE, noun, most)
    }
}

impl<R: Rule> Rule for List<R> {
    type Value = Vec<Spanned<R::Value>>;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Self::Value> {
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ if self.or_one => std::slice::from_ref(node),
            Value::Table(_) if self.heading().is_some_and(|heading| heading.starts_with("[[")) => {
                let heading = self.heading().unwrap_or_default();
                return Diagnostic::error(format!(
                    "`{}` is a list of tables, and single brackets make one table of it",
                    reader.key
                ))
                .at(node.place, format!("expected {heading}"))
                .help(format!(
                    "write double brackets, once for each of the {}",
                    self.noun.split(" (").next().unwrap_or(self.noun)
                ))
                .refuse(reader);
            }
            _ => {
                reader.expected(node, &format!("a list of {}", self.noun));
                return None;
            }
        };
        if items.is_empty() || items.len() > self.most {
            let message = if items.is_empty() {
                format!("the list of {} is empty", self.noun)
            } else {
                format!("{} {} are too many", items.len(), self.noun)
            };
            let expected = match items.len() {
                0 => "expected at least one".to_owned(),
                _ => format!("expected at most {}", self.most),
            };
            return Diagnostic::error(message).at(node.place, expected).refuse(reader);
        }
        let read: Vec<Spanned<R::Value>> = items
            .iter()
            .filter_map(|item| {
                let value = self.item.read(item, reader)?;
                let place = item.place;
                Some(Spanned { value, place })
            })
            .collect();
        (read.len() == items.len()).then_some(read)
    }

    fn heading(&self) -> Option<&'static str> {
        self.item.heading()
    }

    fn example(&self) -> Option<String> {
        self.item.example().filter(|_| self.or_one)
    }

    fn schema(&self) -> Json {
        let item = self.item.schema();
        let list = json!({
            "type": "array", "items": item, "minItems": 1, "maxItems": self.most
        });
        if self.or_one { json!({ "anyOf": [item, list] }) } else { list }
    }

    fn json(&self, value: &Self::Value) -> Json {
        match value.as_slice() {
            [one] if self.or_one => self.item.json(&one.value),
            many => many.iter().map(|at| self.item.json(&at.value)).collect(),
        }
    }
}

/// A key that is present in the file.
#[derive(Debug, Clone)]
pub struct Written {
    /// Its name.
    pub name: &'static str,
    /// Place of its value.
    pub place: Span,
    /// The words of the table's choice with which it has an effect; empty for all.
    pub used_with: Vec<&'static str>,
}

impl Written {
    /// A key with the place of its value, if it is present in the file.
    pub fn key(
        name: &'static str,
        place: Option<Span>,
        used_with: &'static [&'static str],
    ) -> Option<Self> {
        Some(Self { name, place: place?, used_with: used_with.to_vec() })
    }

    /// Whether it has an effect with this word.
    pub fn is_used_with(&self, word: &str) -> bool {
        self.used_with.is_empty() || self.used_with.contains(&word)
    }
}

/// A table with keys of its own.
pub trait Table: Sized {
    /// Its name in messages: `[mud]`.
    const HEADING: &'static str;
    /// Reads the table; mistakes are added to the reader's diagnostics.
    fn read(entries: &Entries, place: Span, reader: &mut Reader) -> Self;
    /// The keys that are present in the file.
    fn written(&self) -> Vec<Written>;
    /// JSON schema of the table.
    fn schema() -> Json;
}

/// The rule of a [`Table`]; if it is missing in the file, all its keys are absent.
pub struct Section<T>(std::marker::PhantomData<T>);

impl<T> Section<T> {
    /// The rule.
    pub const RULE: Self = Self(std::marker::PhantomData);
}

impl<T: Table> Rule for Section<T> {
    type Value = T;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<T> {
        let entries = reader.table(node, T::HEADING)?;
        Some(T::read(entries, node.place, reader))
    }

    fn absent(&self, table: Span, reader: &mut Reader) -> Option<T> {
        Some(T::read(&Entries::default(), table, reader))
    }

    fn heading(&self) -> Option<&'static str> {
        Some(T::HEADING)
    }

    fn schema(&self) -> Json {
        T::schema()
    }
}
