//! Numbers of a fixed unit: decimals and integers.

use serde_json::{Value as Json, json};
use wholestring_units::number_text;

use crate::{
    diagnostic::Diagnostic,
    node::{Node, Value},
    range::Range,
    reader::Reader,
    rule::Rule,
    usual,
};

/// A finite number within a range, or the mistake.
pub fn check_range(
    value: f64,
    range: &Range,
    unit: &str,
    worth: f64,
    node: &Node,
    reader: &mut Reader,
) -> Option<f64> {
    match out_of_range(value, range, unit, worth, node, reader) {
        // Negative zero would be printed with its sign.
        None => Some(value + 0.0),
        Some(mistake) => mistake.refuse(reader),
    }
}

/// The error for a number outside its range.
pub fn out_of_range(
    value: f64,
    range: &Range,
    unit: &str,
    worth: f64,
    node: &Node,
    reader: &Reader,
) -> Option<Diagnostic> {
    if range.holds(value) {
        return None;
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
    if let Some(part) = per_cent(value, range, unit) {
        let part = number_text(part);
        diagnostic = diagnostic.help(format!("for {written} %, write {part}"));
    }
    if !unit.is_empty() && value.is_finite() && matches!(node.value, Value::Number { .. }) {
        diagnostic = diagnostic.help(format!("a number without unit is in {unit}"));
    }
    Some(diagnostic)
}

/// The fraction for a number beyond its range that would be usual as a percentage.
fn per_cent(value: f64, range: &Range, unit: &str) -> Option<f64> {
    let part = value / 100.0;
    let is_usual = match range.usual_numbers() {
        Some((from, to)) => (from..=to).contains(&part),
        None => range.holds(part),
    };
    (unit.is_empty() && value > range.max && range.max <= 2.0 && is_usual).then_some(part)
}

/// A plain number, in a unit that the file does not name.
#[derive(Debug, Clone, Copy)]
pub struct Number {
    /// Its unit; empty if it has none.
    pub unit: &'static str,
    /// The accepted range.
    pub range: Range,
}

impl Number {
    /// A number without unit, from zero.
    pub const fn up_to(max: f64) -> Self {
        Self { unit: "", range: Range::from_to(0.0, max) }
    }
}

impl Rule for Number {
    type Value = f64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<f64> {
        let Value::Number { value, .. } = node.value else {
            let unit =
                if self.unit.is_empty() { String::new() } else { format!(" in {}", self.unit) };
            reader.expected(node, &format!("a number{unit}, without quotes"));
            return None;
        };
        let value = check_range(value, &self.range, self.unit, 1.0, node, reader)?;
        usual::check_number(value, &self.range, self.unit, node, reader);
        Some(value)
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

/// An integer, zero or more.
#[derive(Debug, Clone, Copy)]
pub struct Whole;

impl Rule for Whole {
    type Value = u64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<u64> {
        if let Value::Number { whole: Some(whole), .. } = node.value
            && let Ok(whole) = u64::try_from(whole)
        {
            return Some(whole);
        }
        let message = format!("`{}` must be a whole number, zero or more", reader.key);
        Diagnostic::error(message).at(node.place, "expected a whole number").refuse(reader)
    }

    fn schema(&self) -> Json {
        json!({ "type": "integer", "minimum": 0 })
    }

    fn json(&self, value: &u64) -> Json {
        json!(value)
    }
}

/// An integer between two others.
#[derive(Debug, Clone, Copy)]
pub struct Count {
    /// The smallest.
    pub from: u64,
    /// The largest.
    pub to: u64,
}

impl Rule for Count {
    type Value = u64;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<u64> {
        let Self { from, to } = self;
        if let Value::Number { whole: Some(whole), .. } = node.value
            && let Ok(whole) = u64::try_from(whole)
            && (*from..=*to).contains(&whole)
        {
            return Some(whole);
        }
        let expected = format!("a whole number from {from} to {to}");
        let message = format!("`{}` must be {expected}", reader.key);
        reader
            .report(Diagnostic::error(message).at(node.place, format!("expected {from} to {to}")));
        None
    }

    fn schema(&self) -> Json {
        json!({ "type": "integer", "minimum": self.from, "maximum": self.to })
    }

    fn json(&self, value: &u64) -> Json {
        json!(value)
    }
}
