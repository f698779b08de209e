//! Quantities: numbers with a unit.

use serde_json::{Value as Json, json};
use wholestring_units::{Dimension, QuantityError, QuantityErrorKind, number_text};

use crate::{
    diagnostic::Diagnostic,
    names::short,
    node::{Node, Value},
    number::out_of_range,
    range::Range,
    reader::Reader,
    rule::Rule,
    source::Span,
    usual::Entry,
};

/// Pattern of the beginning of a text that may be a quantity.
const NUMBER_PATTERN: &str = r"^\s*[-+\u2212]?[0-9.\u00BC-\u00BE\u2153-\u215E]";

/// A quantity: text with a unit, or a bare number.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    dimension: Dimension,
    range: Range,
    /// The unit of a bare number and of ranges in messages, and its SI value.
    bare: (&'static str, f64),
    example: &'static str,
}

impl Quantity {
    /// A quantity whose bare number is SI.
    pub fn si(dimension: Dimension, range: Range, example: &'static str) -> Self {
        Self { dimension, range, bare: (dimension.si_symbol(), 1.0), example }
    }

    /// The reason why the key does not accept a value, SI; none if it does.
    pub fn refusal(&self, si: f64) -> Option<String> {
        if self.range.holds(si) {
            return None;
        }
        let (unit, worth) = self.bare;
        let (number, expected) = (number_text(si / worth), self.range.text(unit, worth));
        Some(format!("{number} {unit}: expected {expected}"))
    }

    /// The same with a bare number in `unit`, whose SI value is `worth`.
    pub fn bare(self, unit: &'static str, worth: f64) -> Self {
        Self { bare: (unit, worth), ..self }
    }
}

impl Rule for Quantity {
    type Value = f64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<f64> {
        let (unit, worth) = self.bare;
        let entry = |number: f64, si: f64| Entry {
            dimension: self.dimension,
            range: &self.range,
            unit,
            number,
            si,
            node,
        };
        let (number, si, own_unit) = match &node.value {
            Value::Number { value, .. } => {
                // Zero is the same in every unit; revolutions per minute and degrees are the usual
                // notation.
                if worth == 1.0 && *value != 0.0 && reader.asks_unit(node.place) {
                    let mistake = entry(*value, *value).needs_unit(reader);
                    return mistake.refuse(reader);
                }
                (*value, value * worth, None)
            }
            Value::Text { text, verbatim_from } => match self.dimension.read(text) {
                Ok(written) => (written.number, written.si, Some(written.unit)),
                Err(error) => {
                    if let QuantityErrorKind::NoUnit { number } = &error.kind
                        && reader.is_argument(node.place)
                    {
                        let number = number.parse().unwrap_or(f64::NAN);
                        let mistake = entry(number, number).needs_unit(reader);
                        return mistake.refuse(reader);
                    }
                    let mut place = node.place;
                    if let Some(from) = verbatim_from
                        && !error.span.is_empty()
                    {
                        place.start = from + error.span.start;
                        place.end = from + error.span.end;
                    }
                    reader.report(self.no_quantity(&error, text, place));
                    return None;
                }
            },
            _ => {
                let noun = with_article(self.dimension.name());
                reader.expected(node, &format!("{noun} such as \"{}\"", self.example));
                return None;
            }
        };
        let entry = entry(number, si);
        // The range in the unit of the value.
        let (range_unit, range_worth) =
            own_unit.map_or((unit, worth), |unit| (unit.symbol, unit.factor));
        let mistake = out_of_range(si, &self.range, range_unit, range_worth, node, reader);
        if let Some(mut mistake) = mistake {
            if let Some(advice) = entry.advice(reader) {
                mistake = mistake.help(advice);
            }
            return mistake.refuse(reader);
        }
        entry.check(reader);
        // Negative zero would be printed with its sign.
        Some(si + 0.0)
    }

    fn schema(&self) -> Json {
        let (unit, worth) = self.bare;
        let mut number = json!({
            "type": "number",
            "description": format!("A bare number is in {unit}."),
            "x-unit": unit,
        });
        self.range.describe(&mut number, worth);
        let text = json!({
            "type": "string",
            "description": format!("A {} with its unit: {}.", self.dimension.name(), self.units()),
            "pattern": NUMBER_PATTERN,
            "examples": [self.example],
        });
        json!({ "anyOf": [number, text], "x-dimension": self.dimension.name() })
    }

    fn example(&self) -> Option<String> {
        Some(format!("\"{}\"", self.example))
    }

    fn written(&self, default: &Json) -> String {
        let number = match default.as_f64() {
            Some(large) if large >= 1e5 => format!("{large:e}"),
            Some(number) => number_text(number),
            None => String::new(),
        };
        format!("{number} {}", self.bare.0)
    }

    fn json(&self, value: &f64) -> Json {
        json!(value / self.bare.1)
    }
}

impl Quantity {
    /// The permitted units.
    fn units(&self) -> String {
        let units = self.dimension.units().iter();
        let symbols: Vec<&str> = units.map(|unit| unit.symbol).collect();
        symbols.join(", ")
    }

    fn no_quantity(&self, error: &QuantityError, text: &str, place: Span) -> Diagnostic {
        let name = self.dimension.name();
        let a_name = with_article(name);
        let units = format!("units of {name}: {}", self.units());
        let such_as = format!("expected {a_name} such as \"{}\"", self.example);
        match &error.kind {
            QuantityErrorKind::Empty => {
                Diagnostic::error(format!("there is no {name} here")).at(place, such_as)
            }
            QuantityErrorKind::NotANumber { found } => {
                let found = if found.is_empty() { text } else { found };
                let diagnostic = Diagnostic::error(format!("`{}` is not a number", short(found)))
                    .at(place, such_as);
                if found.contains(',') {
                    diagnostic.help(
                        "decimals follow a point, not a comma; thousands are separated as in \
                         \"20,000 ft\", or not at all",
                    )
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
                    .help(format!("without quotes a number is in {unit}: {}", short(number)))
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
            QuantityErrorKind::AmbiguousUnit { found, meanings } => {
                Diagnostic::error(format!("`{}` is not a unit of {name}", short(found)))
                    .at(place, "ambiguous unit")
                    .help(*meanings)
                    .help(units)
            }
            QuantityErrorKind::AmbiguousComma { found, .. } => {
                let message = format!("`{}` may be thousands or decimals", short(found));
                let help = error.help().unwrap_or_default();
                Diagnostic::error(message).at(place, such_as).help(help)
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
