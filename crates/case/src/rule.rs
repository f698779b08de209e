//! What a value must look like: one rule reads it, checks it and describes it in the schema.

use serde_json::{Value as Json, json};
use wholestring_units::{Dimension, QuantityErrorKind};

use crate::{
    diagnostic::Diagnostic,
    names::{any_of, nearest, short},
    node::{Entries, Node, Value},
    reader::Reader,
    source::Place,
};

/// How a value is read and described.
pub(crate) trait Rule {
    /// What is read.
    type Value;
    /// Reads a value; what is wrong with it goes to the reader.
    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Self::Value>;
    /// What the value is where its key does not stand in the file.
    fn absent(&self, _table: Place, _reader: &mut Reader) -> Option<Self::Value> {
        None
    }
    /// JSON schema of the value.
    fn schema(&self) -> Json;
    /// The heading of the table, if the value is one, for messages.
    fn heading(&self) -> Option<&'static str> {
        None
    }
    /// A value as it is written, for messages.
    fn example(&self) -> Option<String> {
        None
    }
    /// The value as the schema shows defaults.
    fn json(&self, _value: &Self::Value) -> Json {
        Json::Null
    }
}

/// The numbers that are believed, in SI.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Range {
    min: f64,
    min_excluded: bool,
    max: f64,
}

impl Range {
    pub(crate) const fn from_to(min: f64, max: f64) -> Self {
        Self {
            min,
            min_excluded: false,
            max,
        }
    }

    /// More than zero, up to `max`.
    pub(crate) const fn positive_to(max: f64) -> Self {
        Self {
            min: 0.0,
            min_excluded: true,
            max,
        }
    }

    fn holds(&self, value: f64) -> bool {
        let above = if self.min_excluded {
            value > self.min
        } else {
            value >= self.min
        };
        above && value <= self.max
    }

    /// `expected 0.02 to 2 m`, with numbers divided by what one unit is worth.
    fn text(&self, unit: &str, worth: f64) -> String {
        let show = |value: f64| number_text(value / worth);
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!(" {unit}")
        };
        if self.min_excluded {
            format!(
                "more than {} and at most {}{unit}",
                show(self.min),
                show(self.max)
            )
        } else {
            format!("{} to {}{unit}", show(self.min), show(self.max))
        }
    }

    fn describe(&self, schema: &mut Json, worth: f64) {
        let min = if self.min_excluded {
            "exclusiveMinimum"
        } else {
            "minimum"
        };
        schema[min] = json!(self.min / worth);
        schema["maximum"] = json!(self.max / worth);
    }
}

/// A number as a person writes it.
pub(crate) fn number_text(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    if rounded != 0.0 && !(1e-4..1e9).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

/// A finite number within a range, or the mistake.
fn check_range(
    value: f64,
    range: &Range,
    unit: &str,
    worth: f64,
    node: &Node,
    reader: &mut Reader,
) -> Option<f64> {
    if range.holds(value) {
        // Minus zero would print as such.
        return Some(value + 0.0);
    }
    let written = reader.written(node.place);
    let expected = format!("expected {}", range.text(unit, worth));
    let key = reader.key;
    let message = if value.is_nan() {
        format!("`{key}` is not a number: {written}")
    } else if value < 0.0 && range.min >= 0.0 {
        format!("`{key}` is negative: {written}")
    } else if value == 0.0 && range.min_excluded {
        format!("`{key}` must be more than zero")
    } else if value > range.max {
        format!("`{key}` is too large: {written}")
    } else {
        format!("`{key}` is too small: {written}")
    };
    let mut diagnostic = Diagnostic::error(message).at(node.place, expected);
    if !unit.is_empty() && value.is_finite() && matches!(node.value, Value::Number { .. }) {
        diagnostic = diagnostic.help(format!("a number without unit is in {unit}"));
    }
    reader.report(diagnostic);
    None
}

/// How a text that may be a quantity begins.
const NUMBER_PATTERN: &str = r"^\s*[-+\u2212]?[0-9.\u00BC-\u00BE\u2153-\u215E]";

/// A quantity: text with a unit, or a bare number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quantity {
    dimension: Dimension,
    range: Range,
    /// The unit of a bare number and of ranges in messages, and what it is worth in SI.
    bare: (&'static str, f64),
    example: &'static str,
}

impl Quantity {
    /// A quantity whose bare number is SI.
    pub(crate) fn si(dimension: Dimension, range: Range, example: &'static str) -> Self {
        Self {
            dimension,
            range,
            bare: (dimension.si_symbol(), 1.0),
            example,
        }
    }

    /// The same, but a bare number is in `unit`, which is worth so much in SI.
    pub(crate) fn bare(self, unit: &'static str, worth: f64) -> Self {
        Self {
            bare: (unit, worth),
            ..self
        }
    }
}

impl Rule for Quantity {
    type Value = f64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<f64> {
        let (unit, worth) = self.bare;
        let si = match &node.value {
            Value::Number { value, .. } => value * worth,
            Value::Text {
                text,
                verbatim_from,
            } => match self.dimension.parse(text) {
                Ok(si) => si,
                Err(error) => {
                    let mut place = node.place;
                    if let Some(from) = verbatim_from
                        && !error.span.is_empty()
                    {
                        place.start = from + error.span.start;
                        place.end = from + error.span.end;
                    }
                    reader.report(self.no_quantity(&error.kind, text, place));
                    return None;
                }
            },
            _ => {
                let noun = with_article(self.dimension.name());
                reader.expected(node, &format!("{noun} such as \"{}\"", self.example));
                return None;
            }
        };
        check_range(si, &self.range, unit, worth, node, reader)
    }

    fn schema(&self) -> Json {
        let (unit, worth) = self.bare;
        let mut number =
            json!({ "type": "number", "description": format!("A bare number is in {unit}.") });
        self.range.describe(&mut number, worth);
        let units: Vec<&str> = self
            .dimension
            .units()
            .iter()
            .map(|unit| unit.symbol)
            .collect();
        let text = json!({
            "type": "string",
            "description": format!("A {} with its unit: {}.", self.dimension.name(), units.join(", ")),
            "pattern": NUMBER_PATTERN,
            "examples": [self.example],
        });
        json!({ "anyOf": [number, text] })
    }

    fn example(&self) -> Option<String> {
        Some(format!("\"{}\"", self.example))
    }

    fn json(&self, value: &f64) -> Json {
        json!(value / self.bare.1)
    }
}

impl Quantity {
    fn no_quantity(&self, kind: &QuantityErrorKind, text: &str, place: Place) -> Diagnostic {
        let name = self.dimension.name();
        let a_name = with_article(name);
        let units: Vec<&str> = self
            .dimension
            .units()
            .iter()
            .map(|unit| unit.symbol)
            .collect();
        let units = format!("units of {name}: {}", units.join(", "));
        let such_as = format!("expected {a_name} such as \"{}\"", self.example);
        match kind {
            QuantityErrorKind::Empty => {
                Diagnostic::error(format!("there is no {name} here")).at(place, such_as)
            }
            QuantityErrorKind::NotANumber { found } => {
                let found = if found.is_empty() { text } else { found };
                let diagnostic = Diagnostic::error(format!("`{}` is not a number", short(found)))
                    .at(place, such_as);
                if found.contains(',') {
                    diagnostic.help("decimals stand after a point; thousands are not separated")
                } else {
                    diagnostic
                }
            }
            QuantityErrorKind::TooLarge { found } => {
                Diagnostic::error(format!("`{}` is too large for {a_name}", short(found)))
                    .at(place, such_as)
            }
            QuantityErrorKind::NoUnit { number } => {
                let (unit, _) = self.bare;
                Diagnostic::error(format!("\"{}\" has no unit", short(text)))
                    .at(place, "expected a unit after the number")
                    .help(format!(
                        "without quotes a number is in {unit}: {}",
                        short(number)
                    ))
                    .help(units)
            }
            QuantityErrorKind::UnknownUnit { found, nearest } => {
                let diagnostic =
                    Diagnostic::error(format!("`{}` is not a unit of {name}", short(found)))
                        .at(place, "unknown unit");
                match nearest {
                    Some(nearest) => diagnostic.help(format!("did you mean `{nearest}`?")),
                    None => diagnostic,
                }
                .help(units)
            }
            QuantityErrorKind::OtherDimension { found, is } => Diagnostic::error(format!(
                "`{}` is a unit of {}, not of {name}",
                short(found),
                is.name()
            ))
            .at(place, format!("expected {a_name}"))
            .help(units),
        }
    }
}

/// "a length", "an angle".
fn with_article(noun: &str) -> String {
    let vowel = noun.starts_with(['a', 'e', 'i', 'o', 'u']);
    format!("{} {noun}", if vowel { "an" } else { "a" })
}

/// A plain number, in a unit that texts do not name.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Number {
    pub(crate) unit: &'static str,
    pub(crate) range: Range,
}

impl Rule for Number {
    type Value = f64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<f64> {
        let Value::Number { value, .. } = node.value else {
            let unit = if self.unit.is_empty() {
                String::new()
            } else {
                format!(" in {}", self.unit)
            };
            reader.expected(node, &format!("a number{unit}, without quotes"));
            return None;
        };
        check_range(value, &self.range, self.unit, 1.0, node, reader)
    }

    fn schema(&self) -> Json {
        let mut schema = json!({ "type": "number" });
        self.range.describe(&mut schema, 1.0);
        schema
    }

    fn json(&self, value: &f64) -> Json {
        json!(value)
    }
}

/// A whole number, zero or more.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Whole;

impl Rule for Whole {
    type Value = u64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<u64> {
        if let Value::Number {
            whole: Some(whole), ..
        } = node.value
            && let Ok(whole) = u64::try_from(whole)
        {
            return Some(whole);
        }
        let message = format!("`{}` must be a whole number, zero or more", reader.key);
        reader.report(Diagnostic::error(message).at(node.place, "expected a whole number"));
        None
    }

    fn schema(&self) -> Json {
        json!({ "type": "integer", "minimum": 0 })
    }

    fn json(&self, value: &u64) -> Json {
        json!(value)
    }
}

/// A text that says something.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Text;

impl Rule for Text {
    type Value = String;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<String> {
        let Value::Text { text, .. } = &node.value else {
            reader.expected(node, "text in quotes");
            return None;
        };
        let problem = if text.trim().is_empty() {
            "is empty"
        } else if text.chars().any(char::is_control) {
            "holds a line break or another control character"
        } else if text.chars().count() > 200 {
            "is longer than 200 characters"
        } else {
            return Some(text.clone());
        };
        let message = format!("`{}` {problem}", reader.key);
        reader.report(Diagnostic::error(message).at(node.place, "expected a short text"));
        None
    }

    fn schema(&self) -> Json {
        json!({ "type": "string", "minLength": 1, "maxLength": 200 })
    }
}

/// One of a few words.
pub(crate) struct Choice<T: 'static> {
    /// What is chosen, for messages.
    pub(crate) noun: &'static str,
    /// The words and what they mean.
    pub(crate) words: &'static [(&'static str, T)],
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
        reader.report(diagnostic);
        None
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

/// A value and the place it stands at.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct At<T> {
    pub(crate) value: T,
    pub(crate) place: Place,
}

/// A list, each item by the same rule.
pub(crate) struct List<R> {
    pub(crate) item: R,
    /// Whether one item may stand without brackets.
    pub(crate) or_one: bool,
    /// What it is a list of, for messages.
    pub(crate) noun: &'static str,
    /// More are refused.
    pub(crate) most: usize,
}

impl<R: Rule> Rule for List<R> {
    type Value = Vec<At<R::Value>>;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Self::Value> {
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ if self.or_one => std::slice::from_ref(node),
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
            reader.report(Diagnostic::error(message).at(node.place, expected));
            return None;
        }
        let read: Vec<At<R::Value>> = items
            .iter()
            .filter_map(|item| {
                let value = self.item.read(item, reader)?;
                let place = item.place;
                Some(At { value, place })
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
        if self.or_one {
            json!({ "anyOf": [item, list] })
        } else {
            list
        }
    }

    fn json(&self, value: &Self::Value) -> Json {
        match value.as_slice() {
            [one] if self.or_one => self.item.json(&one.value),
            many => many.iter().map(|at| self.item.json(&at.value)).collect(),
        }
    }
}

/// A table with keys of its own.
pub(crate) trait Table: Sized {
    /// How messages call it: `[mud]`.
    const HEADING: &'static str;
    fn read(entries: &Entries, place: Place, reader: &mut Reader) -> Self;
    fn schema() -> Json;
}

/// The rule of a [`Table`]; where it does not stand in the file, all its keys are absent.
pub(crate) struct Section<T>(std::marker::PhantomData<T>);

impl<T> Section<T> {
    pub(crate) const RULE: Self = Self(std::marker::PhantomData);
}

impl<T: Table> Rule for Section<T> {
    type Value = T;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<T> {
        let entries = reader.table(node, T::HEADING)?;
        Some(T::read(entries, node.place, reader))
    }

    fn absent(&self, table: Place, reader: &mut Reader) -> Option<T> {
        Some(T::read(&Entries::default(), table, reader))
    }

    fn heading(&self) -> Option<&'static str> {
        Some(T::HEADING)
    }

    fn schema(&self) -> Json {
        T::schema()
    }
}
