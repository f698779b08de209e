//! Errors of quantities.

use std::fmt;
use std::ops::Range;

use crate::{Dimension, print::without_trailing_zeros};

/// Error in the text of a quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum QuantityErrorKind {
    /// The text contains only blanks.
    Empty,
    /// The text does not begin with a number, or the number is in an unsupported form (decimal
    /// commas, NaN, infinity).
    NotANumber {
        /// The text in place of the number.
        found: String,
    },
    /// The number, or its value in SI, is too large for a double.
    TooLarge {
        /// The number as written.
        found: String,
    },
    /// A number without a unit.
    NoUnit {
        /// The number as written.
        number: String,
    },
    /// A unit of no known dimension.
    UnknownUnit {
        /// The unit as written.
        found: String,
        /// Symbol of the unit with the nearest spelling, if one is near.
        nearest: Option<&'static str>,
    },
    /// An ambiguous unit.
    AmbiguousUnit {
        /// The unit as written.
        found: String,
        /// Its possible meanings and the alternatives to write.
        meanings: &'static str,
    },
    /// A comma that may separate thousands or decimals: `1,500 m`.
    AmbiguousComma {
        /// The number as written.
        found: String,
        /// Symbol of its unit.
        unit: &'static str,
    },
    /// A unit of another dimension.
    OtherDimension {
        /// The unit as written.
        found: String,
        /// Its dimension.
        is: Dimension,
    },
}

/// Reason why a text is not a quantity of the requested dimension.
///
/// Its `Display` is one sentence for the person who wrote the text: the error, the expected text,
/// and the accepted units.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct QuantityError {
    /// Kind of error.
    pub kind: QuantityErrorKind,
    /// Place in the text, in bytes, on character boundaries.
    pub span: Range<usize>,
    /// The dimension that was requested.
    pub dimension: Dimension,
}

impl QuantityError {
    /// Advice beyond the sentence, if there is any: the short text for a help line or a label.
    pub fn help(&self) -> Option<String> {
        match &self.kind {
            QuantityErrorKind::UnknownUnit { nearest: Some(nearest), .. } => {
                Some(format!("did you mean '{nearest}'?"))
            }
            QuantityErrorKind::AmbiguousUnit { meanings, .. } => Some((*meanings).to_owned()),
            QuantityErrorKind::AmbiguousComma { found, unit } => {
                let [whole, decimal] = both_ways(found);
                Some(format!("write '{whole} {0}' or '{decimal} {0}'", unit))
            }
            _ => None,
        }
    }
}

impl std::error::Error for QuantityError {}

impl fmt::Display for QuantityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let dimension = self.dimension.name();
        let a_dimension = with_article(dimension);
        let units = accepted(self.dimension);
        let example = format!("1 {}", self.dimension.units()[0].symbol);
        match &self.kind {
            QuantityErrorKind::Empty => {
                write!(f, "there is nothing here; {a_dimension} was expected, such as '{example}'")
            }
            QuantityErrorKind::NotANumber { found } => {
                write!(f, "'{}' is not a number; {a_dimension} was expected", shown(found))?;
                if found.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)) {
                    write!(
                        f,
                        ", its decimals after a point and its thousands not separated: '1500.5 {}'",
                        self.dimension.units()[0].symbol
                    )
                } else {
                    write!(f, ", such as '{example}'")
                }
            }
            QuantityErrorKind::TooLarge { found } => {
                write!(f, "'{}' is too large for {a_dimension}", shown(found))
            }
            QuantityErrorKind::NoUnit { number } => write!(
                f,
                "'{}' has no unit; {a_dimension} was expected, with one of: {units}",
                shown(number)
            ),
            QuantityErrorKind::UnknownUnit { found, nearest } => {
                write!(f, "'{}' is not a unit of {dimension}", shown(found))?;
                if let Some(nearest) = nearest {
                    write!(f, "; did you mean '{nearest}'?")?;
                    write!(f, " Accepted: {units}")
                } else {
                    write!(f, "; accepted: {units}")
                }
            }
            QuantityErrorKind::AmbiguousUnit { found, meanings } => {
                write!(f, "'{}' is not a unit of {dimension}: {meanings}", shown(found))
            }
            QuantityErrorKind::AmbiguousComma { found, unit } => {
                let [whole, decimal] = both_ways(found);
                write!(
                    f,
                    "'{0}' may be {whole} or {decimal}; write '{whole} {1}' or '{decimal} {1}'",
                    shown(found),
                    unit
                )
            }
            QuantityErrorKind::OtherDimension { found, is } => write!(
                f,
                "'{}' is a unit of {}; {a_dimension} was expected, with one of: {units}",
                shown(found),
                is.name()
            ),
        }
    }
}

/// A number with a comma, read as thousands and as decimals.
pub(crate) fn both_ways(found: &str) -> [String; 2] {
    let decimal = found.replace(',', ".");
    [found.replace(',', ""), without_trailing_zeros(&decimal).to_owned()]
}

/// The symbols that a dimension accepts.
fn accepted(dimension: Dimension) -> String {
    let symbols: Vec<&str> = dimension.units().iter().map(|unit| unit.symbol).collect();
    symbols.join(", ")
}

/// "a length", "an angle".
fn with_article(noun: &str) -> String {
    let article = if noun.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("{article} {noun}")
}

/// Foreign text inside a sentence: short, and without control characters.
fn shown(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut excerpt: String =
        text.chars().take(LONGEST).map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() {
        excerpt.push_str("...");
    }
    excerpt
}
