//! A table of a case: keys with values and their origins; notes on a file, its contents and the
//! path of a well in it.

use wholestring::well::{Station, TieIn};
use wholestring_units::{Unit, significant};

/// A key of the case file with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The key, as in the case file.
    pub key: &'static str,
    /// Its value.
    pub value: Value,
    /// Its origin.
    pub origin: Origin,
}

/// A table of the case file, or one of several.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// Comment above it.
    pub remark: Option<String>,
    /// Its keys, in the order of the file.
    pub entries: Vec<Entry>,
}

impl Block {
    /// Adds a key.
    pub fn push(&mut self, key: &'static str, value: Value, origin: Origin) {
        self.entries.push(Entry { key, value, origin });
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.entries.iter().find(|entry| entry.key == key).map(|entry| &entry.value)
    }
}

// A value of a case, in the unit of its file.

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

// Origin of a value.

/// Origin of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum Origin {
    /// A place in the file and its text, including the unit where it differs from that of `value`.
    Found {
        /// Such as `line 5, column 'OD'`, `sheet 'BHA', cell C7`, `tubularComponent 3, od`.
        place: String,
        /// The text as written, if the value differs from it: `8 1/2`.
        written: Option<String>,
    },
    /// The value follows from others in the file.
    Derived {
        /// Source and method, in words.
        from: String,
    },
    /// The file does not give it.
    Assumed {
        /// Reason of the assumption.
        because: String,
    },
}

impl Origin {
    /// A place whose text equals the value.
    pub fn at(place: impl Into<String>) -> Self {
        Origin::Found { place: place.into(), written: None }
    }

    /// A place and the text written there.
    pub fn written(place: impl Into<String>, written: impl Into<String>) -> Self {
        Origin::Found { place: place.into(), written: Some(written.into()) }
    }
}

// Notes of an import.

/// A sentence on the interpretation of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Note {
    /// An assumption on a value that the file does not give.
    Assumed(String),
    /// Contents of the file that are not in the case, with the reason.
    LeftOut(String),
    /// Disagreement of two statements of the file, or a value that is probably wrong.
    Warning(String),
    /// Agreement of two statements of the file, or the one that is used of two.
    Checked(String),
    /// Information on reading.
    Read(String),
}

impl Note {
    /// The sentence.
    pub fn text(&self) -> &str {
        match self {
            Note::Assumed(text)
            | Note::LeftOut(text)
            | Note::Warning(text)
            | Note::Checked(text)
            | Note::Read(text) => text,
        }
    }

    /// Kind of note: `warning`, `assumed`, `left out`, `checked`, `read`.
    pub fn kind(&self) -> &'static str {
        match self {
            Note::Assumed(_) => "assumed",
            Note::LeftOut(_) => "left out",
            Note::Warning(_) => "warning",
            Note::Checked(_) => "checked",
            Note::Read(_) => "read",
        }
    }
}

// The path of a well in a file.

/// Stations of a path and their location.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The stations, m and rad, down the hole.
    pub stations: Vec<Station>,
    /// Position of the first one, if given in the file.
    pub tie_in: Option<TieIn>,
    /// Their location: `lines 13 to 165`, `trajectory 'Plan #2'`.
    pub place: String,
    /// Their units in the file: `ft, deg, deg`.
    pub units: String,
}

// Description of a file and its contents.

/// Description of a file and its contents, in words.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Contents {
    /// Kind of file: `a survey`, `WITSML 1.4.1.1`.
    pub what: String,
    /// Contents, one line each: `tubular 'BHA 7': 12 components`; warnings begin with `warning: `.
    pub lines: Vec<String>,
    /// Mistakes for which a calibration refuses the file, in sentences.
    pub errors: Vec<String>,
}
