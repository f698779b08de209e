//! A value of a case, in the unit of its file.

use wholestring_units::{Unit, significant};

/// A value as in a case file, in the unit of its source.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number with its unit.
    Quantity {
        /// The number, in this unit.
        number: f64,
        /// The unit.
        unit: &'static Unit,
    },
    /// A number without a unit: a friction factor, rev/min.
    Number(f64),
    /// A text.
    Text(String),
    /// A list of texts.
    Words(Vec<String>),
}

impl Value {
    /// Returns a quantity.
    pub fn quantity(number: f64, unit: &'static Unit) -> Self {
        Value::Quantity { number, unit }
    }

    /// Returns a text.
    pub fn text(text: impl Into<String>) -> Self {
        Value::Text(text.into())
    }

    /// The number in SI; `None` for texts.
    pub fn si(&self) -> Option<f64> {
        match self {
            Value::Quantity { number, unit } => Some(unit.to_si(*number)),
            Value::Number(number) => Some(*number),
            Value::Text(_) | Value::Words(_) => None,
        }
    }

    /// As TOML.
    pub(crate) fn toml(&self) -> String {
        match self {
            Value::Quantity { number, unit } => {
                quoted(&format!("{} {}", rounded(*number), unit.symbol))
            }
            Value::Number(number) => rounded(*number).to_string(),
            Value::Text(text) => quoted(text),
            Value::Words(words) => {
                let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
                format!("[{}]", words.join(", "))
            }
        }
    }
}

/// Twelve significant digits: more than any file has, and without the rounding errors of conversion
/// factors.
pub(crate) fn rounded(value: f64) -> f64 {
    significant(value, 12)
}

/// A basic string of TOML.
pub(crate) fn quoted(text: &str) -> String {
    let mut quoted = String::with_capacity(text.len() + 2);
    quoted.push('"');
    for character in text.chars() {
        match character {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            // Control characters are not needed in a name.
            other if other.is_control() => quoted.push(' '),
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}
