//! Texts whose quantities are rendered in any unit set.

use std::fmt::{self, Display, Write as _};

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use wholestring_units::{Dimension, UnitSet};

/// Characters of the private-use area that enclose a quantity within a text, and that separate its
/// dimension, rounding and value. No other text contains them.
const BEGIN: char = '\u{e000}';
const BETWEEN: char = '\u{e001}';
const END: char = '\u{e002}';

/// Rounding of a quantity in a sentence, in the unit in which it is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rounding {
    /// Five significant digits, without trailing zeros.
    Five,
    /// Four significant digits, without trailing zeros.
    Four,
    /// Three significant digits, with trailing zeros.
    Three,
    /// Three significant digits, without trailing zeros.
    ThreeShort,
    /// Two significant digits, rounded down, without trailing zeros.
    TwoDown,
    /// A deviation with two significant digits; `0` where it is below any measurement.
    Deviation,
    /// One decimal, without a trailing zero.
    Tenth,
    /// One decimal.
    OneDecimal,
    /// Whole units.
    Whole,
}

impl Rounding {
    const ALL: [Self; 9] = [
        Self::Five,
        Self::Four,
        Self::Three,
        Self::ThreeShort,
        Self::TwoDown,
        Self::Deviation,
        Self::Tenth,
        Self::OneDecimal,
        Self::Whole,
    ];

    /// The number and its unit.
    fn text(self, dimension: Dimension, si: f64, units: UnitSet) -> String {
        let unit = dimension.unit_in(units);
        let value = unit.from_si(si);
        let number = match self {
            Self::Five => return dimension.format(si, units),
            Self::Four => return dimension.format(si * rounded(value, 4), units),
            Self::ThreeShort => return dimension.format(si * rounded(value, 3), units),
            Self::Tenth => {
                let part = if value == 0.0 { 1.0 } else { (10.0 * value).round() / 10.0 / value };
                return dimension.format(si * part, units);
            }
            Self::Three => {
                let digits = 2 - libm::log10(value.abs().max(1e-9)).floor() as i32;
                format!("{value:.*}", digits.clamp(0, 6) as usize)
            }
            Self::TwoDown => {
                let scale = libm::pow(10.0_f64, 1.0 - libm::log10(value).floor());
                format!("{}", (value * scale).floor() / scale)
            }
            Self::Deviation => crate::quantities::deviation(value),
            Self::OneDecimal => format!("{:.1}", value + 0.0),
            // The surface is at 0, not at -0.
            Self::Whole => format!("{:.0}", value + 0.0),
        };
        format!("{number} {}", unit.symbol)
    }
}

/// Value with so many significant digits, over the value.
fn rounded(value: f64, digits: i32) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return 1.0;
    }
    let scale = libm::pow(10.0_f64, f64::from(digits - 1) - libm::log10(value.abs()).floor());
    (value * scale).round() / scale / value
}

/// A quantity within a text. Its [`Display`] marks it, so that a [`Wording`] of the text renders
/// it in any unit set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    dimension: Dimension,
    si: f64,
    rounding: Rounding,
}

impl Quantity {
    /// A quantity, SI, and its rounding.
    pub const fn new(dimension: Dimension, si: f64, rounding: Rounding) -> Self {
        Self { dimension, si, rounding }
    }

    /// A depth in whole units.
    pub const fn depth(md_m: f64) -> Self {
        Self::new(Dimension::Length, md_m, Rounding::Whole)
    }

    /// The quantity within its delimiters; `None` for a damaged one.
    fn parse(text: &str) -> Option<Self> {
        let mut parts = text.split(BETWEEN);
        let (dimension, rounding, si) = (parts.next()?, parts.next()?, parts.next()?);
        Some(Self {
            dimension: *Dimension::ALL.get(dimension.parse::<usize>().ok()?)?,
            rounding: *Rounding::ALL.get(rounding.parse::<usize>().ok()?)?,
            si: si.parse().ok()?,
        })
    }

    fn text(&self, units: UnitSet) -> String {
        self.rounding.text(self.dimension, self.si, units)
    }
}

impl Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { dimension, si, rounding } = self;
        let dimension = Dimension::ALL.iter().position(|one| one == dimension).unwrap_or(0);
        let rounding = Rounding::ALL.iter().position(|one| one == rounding).unwrap_or(0);
        write!(f, "{BEGIN}{dimension}{BETWEEN}{rounding}{BETWEEN}{si:?}{END}")
    }
}

/// A text whose quantities are marked; empty where no text is known.
///
/// ```
/// use wholestring_judge::{Quantity, Rounding, Wording};
/// use wholestring_units::{Dimension, UnitSet};
///
/// let load = Quantity::new(Dimension::Force, 711.2e3, Rounding::Four);
/// let wording = Wording::from(format!("load {load} at {}", Quantity::depth(304.8)));
/// assert_eq!(wording.in_units(UnitSet::Si), "load 711.2 kN at 305 m");
/// assert_eq!(wording.in_units(UnitSet::Field), "load 159.9 klbf at 1000 ft");
/// ```
///
/// In JSON it is an array of texts and of quantities, SI; in formats for programs one string.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Wording(String);

/// A part of a wording in JSON.
#[derive(Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "a part of a sentence is neither a text nor a quantity with value, dimension and rounding"
)]
enum Part {
    Text(String),
    Quantity { value: Option<f64>, dimension: String, rounding: Rounding },
}

impl Wording {
    /// The text in these units.
    pub fn in_units(&self, units: UnitSet) -> String {
        let mut text = String::with_capacity(self.0.len());
        for piece in self.pieces() {
            match piece {
                Ok(words) => text.push_str(words),
                Err(quantity) => text.push_str(&quantity.text(units)),
            }
        }
        text
    }

    /// Whether no text is known.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether the text is the same in all units.
    pub fn is_plain(&self) -> bool {
        !self.0.contains(BEGIN)
    }

    /// Words, and quantities between them.
    fn pieces(&self) -> impl Iterator<Item = Result<&str, Quantity>> {
        let mut rest = self.0.as_str();
        std::iter::from_fn(move || {
            if rest.is_empty() {
                return None;
            }
            let Some(marked) = rest.strip_prefix(BEGIN) else {
                let (words, after) = rest.split_at(rest.find(BEGIN).unwrap_or(rest.len()));
                rest = after;
                return Some(Ok(words));
            };
            let (marked, after) = marked.split_once(END).unwrap_or((marked, ""));
            rest = after;
            Some(Quantity::parse(marked).map_or(Ok(""), Err))
        })
    }
}

impl From<String> for Wording {
    fn from(text: String) -> Self {
        Self(text)
    }
}

impl From<&str> for Wording {
    fn from(text: &str) -> Self {
        Self(text.to_owned())
    }
}

/// The text within a longer one, its quantities marked.
impl Display for Wording {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Serialize for Wording {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if !serializer.is_human_readable() {
            return self.0.serialize(serializer);
        }
        serializer.collect_seq(self.pieces().map(|piece| match piece {
            Ok(words) => Part::Text(words.to_owned()),
            Err(Quantity { dimension, si, rounding }) => {
                Part::Quantity { value: Some(si), dimension: dimension.name().to_owned(), rounding }
            }
        }))
    }
}

impl<'de> Deserialize<'de> for Wording {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        if !deserializer.is_human_readable() {
            return String::deserialize(deserializer).map(Self);
        }
        let mut text = String::new();
        for part in Vec::<Part>::deserialize(deserializer)? {
            match part {
                Part::Text(words) => text.push_str(&words),
                Part::Quantity { value, dimension, rounding } => {
                    let known = Dimension::ALL.iter().find(|one| one.name() == dimension);
                    let dimension = *known.ok_or_else(|| {
                        serde::de::Error::custom(format!("{dimension:?} is not a dimension"))
                    })?;
                    let si = value.unwrap_or(f64::NAN);
                    let _ = write!(text, "{}", Quantity { dimension, si, rounding });
                }
            }
        }
        Ok(Self(text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every dimension and rounding survives JSON, and a text that a user wrote is left alone.
    #[test]
    fn wordings_survive_their_files() {
        for &dimension in Dimension::ALL {
            for rounding in Rounding::ALL {
                for si in [0.0, -0.0, 12345.678, -3e-3, 1e300, f64::MIN_POSITIVE] {
                    let quantity = Quantity::new(dimension, si, rounding);
                    let wording =
                        Wording::from(format!("5\" {{drill}} pipe, {quantity}: \"{quantity}\""));
                    let json = serde_json::to_string(&wording).expect("JSON");
                    let read: Wording = serde_json::from_str(&json).expect("a wording");
                    assert_eq!(read, wording, "{json}");
                    assert!(!json.contains([BEGIN, BETWEEN, END]), "{json}");
                }
            }
        }
        let nan = Quantity::new(Dimension::Force, f64::NAN, Rounding::Four);
        let json = serde_json::to_string(&Wording::from(format!("{nan}"))).expect("JSON");
        let read: Wording = serde_json::from_str(&json).expect("a wording");
        assert_eq!(read.in_units(UnitSet::Field), "NaN klbf");
        assert!(
            serde_json::from_str::<Wording>(
                "[{\"value\":1,\"dimension\":\"x\",\"rounding\":\"five\"}]"
            )
            .is_err()
        );
    }

    #[test]
    fn damaged_marks_are_left_out() {
        for damaged in ["\u{e000}", "\u{e000}99\u{e001}0\u{e001}1\u{e002}", "\u{e000}0\u{e002}"] {
            let wording = Wording::from(format!("a {damaged}"));
            assert_eq!(wording.in_units(UnitSet::Si), "a ");
        }
    }
}
