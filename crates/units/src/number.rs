//! Parses a quantity: its number, then its unit.

use crate::{Dimension, QuantityError, QuantityErrorKind, Written, nearest, thousands};

impl Dimension {
    /// Reads a number and a unit, and returns the value in SI.
    ///
    /// The number may be a decimal (`-1.5e3`), a fraction (`5/8`) or a mixed one (`5-1/2`, `5 1/2`,
    /// `5½`), and its thousands may be separated where this is unambiguous (`20,000 ft`,
    /// `1 500 m`). The unit may follow with or without blanks. Feet and inches may be one length:
    /// `6' 5"`.
    ///
    /// ```
    /// use wholestring_units::Dimension;
    ///
    /// assert_eq!(Dimension::Diameter.parse("9 5/8\"")?, 0.244475);
    /// assert_eq!(Dimension::Length.parse("-1.5e3 m")?, -1500.0);
    /// assert_eq!(Dimension::Length.parse("20,000 ft")?, 6096.0);
    /// let error = Dimension::Length.parse("4305").unwrap_err();
    /// assert!(error.to_string().starts_with("'4305' has no unit; a length was expected"));
    /// # Ok::<(), wholestring_units::QuantityError>(())
    /// ```
    pub fn parse(self, text: &str) -> Result<f64, QuantityError> {
        self.read(text).map(|written| written.si)
    }

    /// Reads a quantity as [`parse`](Self::parse) does, and also returns its number and unit.
    ///
    /// ```
    /// use wholestring_units::Dimension;
    ///
    /// let weight = Dimension::Force.read("12 klbf")?;
    /// assert_eq!((weight.number, weight.unit.symbol), (12.0, "klbf"));
    /// # Ok::<(), wholestring_units::QuantityError>(())
    /// ```
    pub fn read(self, text: &str) -> Result<Written, QuantityError> {
        quantity(self, text)
    }
}

/// Reads a number and a unit of the dimension.
fn quantity(dimension: Dimension, text: &str) -> Result<Written, QuantityError> {
    let error =
        |kind, start: usize, end: usize| QuantityError { kind, span: start..end, dimension };
    let end = text.trim_end().len();
    let start = end - text.trim().len();
    if start == end {
        return Err(error(QuantityErrorKind::Empty, 0, text.len()));
    }

    if let Some(written) = with_thousands(dimension, text, start, end) {
        return written;
    }
    if let Some(written) = feet_and_inches(dimension, &text[start..end]) {
        return Ok(written);
    }
    let Some((number, number_end)) = number(&text[..end], start) else {
        let stop = word_end(text, start, end);
        let found = text[start..stop].to_owned();
        return Err(error(QuantityErrorKind::NotANumber { found }, start, stop));
    };
    let written = text[start..number_end].to_owned();
    if !number.is_finite() {
        let found = written;
        return Err(error(QuantityErrorKind::TooLarge { found }, start, number_end));
    }

    let unit_start = end - text[number_end..end].trim_start().len();
    let unit_text = &text[unit_start..end];
    if unit_text.is_empty() {
        let number = written;
        return Err(error(QuantityErrorKind::NoUnit { number }, start, number_end));
    }
    if let Some(unit) = dimension.find_unit(unit_text) {
        let si = unit.to_si(number);
        return if si.is_finite() {
            Ok(Written { number, unit, si })
        } else {
            Err(error(QuantityErrorKind::TooLarge { found: written }, start, number_end))
        };
    }
    // A second number in place of the unit belongs to the number: "1,500 m", "1.2.3 m".
    if unit_text.starts_with(|c: char| c.is_ascii_digit() || ".,_'/+-–−".contains(c))
        && unit_text.contains(|c: char| c.is_ascii_digit())
    {
        let stop = numeric_end(text, unit_start, end);
        let found = text[start..stop].to_owned();
        return Err(error(QuantityErrorKind::NotANumber { found }, start, stop));
    }
    let other = Dimension::ALL.iter().find(|other| other.find_unit(unit_text).is_some());
    let found = unit_text.to_owned();
    let kind = match (other, nearest::meanings(unit_text)) {
        (Some(&is), _) => QuantityErrorKind::OtherDimension { found, is },
        (None, Some(meanings)) => QuantityErrorKind::AmbiguousUnit { found, meanings },
        (None, None) => QuantityErrorKind::UnknownUnit {
            nearest: nearest::nearest(dimension.units(), unit_text),
            found,
        },
    };
    Err(error(kind, unit_start, end))
}

/// Parses a number with separated thousands and its unit; `None` for any other text.
fn with_thousands(
    dimension: Dimension,
    text: &str,
    start: usize,
    end: usize,
) -> Option<Result<Written, QuantityError>> {
    let sign = text[start..].chars().next().filter(|c| "+-−".contains(*c));
    let digits = start + sign.map_or(0, char::len_utf8);
    let parted = thousands::parted(&text[..end], digits)?;
    let unit = dimension.find_unit(&text[parted.end..end])?;
    let found = || text[start..parted.end].to_owned();
    let error = |kind| QuantityError { kind, span: start..parted.end, dimension };
    if parted.is_unsure && !unit.is_field() {
        return Some(Err(error(QuantityErrorKind::AmbiguousComma {
            found: found(),
            unit: unit.symbol,
        })));
    }
    let number = if matches!(sign, Some('-' | '−')) { -parted.value } else { parted.value };
    let si = unit.to_si(number);
    Some(match si.is_finite() {
        true => Ok(Written { number, unit, si }),
        false => Err(error(QuantityErrorKind::TooLarge { found: found() })),
    })
}

/// A length in feet and inches, `6' 5-1/2"`: both in feet.
fn feet_and_inches(dimension: Dimension, text: &str) -> Option<Written> {
    let feet_text = text.find(['\'', '’', '′']).filter(|at| *at > 0)?;
    let mark = text[feet_text..].chars().next()?;
    let inches_text = text[feet_text + mark.len_utf8()..].trim_start().trim_start_matches('-');
    let (feet_unit, inch_unit) = (dimension.find_unit("ft")?, dimension.find_unit("in")?);
    let (feet, feet_end) = number(&text[..feet_text], 0)?;
    let (inches, inches_end) = number(inches_text, 0)?;
    let is_inch = matches!(inches_text[inches_end..].trim(), "\"" | "”" | "″" | "''" | "in");
    let is_whole = feet.fract() == 0.0 && text[feet_end..feet_text].trim().is_empty();
    if !is_inch || !is_whole || feet < 0.0 || !(0.0..12.0).contains(&inches) {
        return None;
    }
    let si = feet_unit.to_si(feet) + inch_unit.to_si(inches);
    let number = feet + inches / 12.0;
    si.is_finite().then_some(Written { number, unit: feet_unit, si })
}

/// The number that begins at `start`, and where it ends.
fn number(text: &str, start: usize) -> Option<(f64, usize)> {
    let mut at = start;
    let mut sign = 1.0;
    if let Some(c) = text[at..].chars().next().filter(|c| "+-−".contains(*c)) {
        sign = if c == '+' { 1.0 } else { -1.0 };
        at += c.len_utf8();
    }
    if let Some((part, end)) = vulgar_fraction(text, at) {
        return Some((sign * part, end));
    }
    let whole_end = digits_end(text, at);
    let (value, end) = decimal(text, at)?;
    if end > whole_end {
        return Some((sign * value, end));
    }

    // A whole number: it may be the numerator of a fraction, or precede one.
    if let Some((bottom, end)) = denominator(text, whole_end) {
        return Some((sign * value / bottom, end));
    }
    let gap = &text[whole_end..];
    let fraction_at = match gap.chars().next() {
        Some(dash @ ('-' | '–')) => whole_end + dash.len_utf8(),
        _ => text.len() - gap.trim_start().len(),
    };
    if let Some((part, end)) = vulgar_fraction(text, fraction_at) {
        return Some((sign * (value + part), end));
    }
    let top_end = digits_end(text, fraction_at);
    if fraction_at > whole_end
        && let Ok(top) = text[fraction_at..top_end].parse::<f64>()
        && let Some((bottom, end)) = denominator(text, top_end)
        && top < bottom
    {
        return Some((sign * (value + top / bottom), end));
    }
    Some((sign * value, whole_end))
}

/// An unsigned decimal with or without an exponent: its value and its end.
fn decimal(text: &str, start: usize) -> Option<(f64, usize)> {
    let bytes = text.as_bytes();
    let mut end = digits_end(text, start);
    let mut count = end - start;
    if bytes.get(end) == Some(&b'.') {
        let after = digits_end(text, end + 1);
        count += after - (end + 1);
        end = after;
    }
    if count == 0 {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let signed = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = end + 1 + signed;
        let exponent_end = digits_end(text, exponent.min(text.len()));
        if exponent_end > exponent {
            end = exponent_end;
        }
    }
    let value = text[start..end].parse().ok()?;
    Some((value, end))
}

/// `/` and a whole number above zero.
fn denominator(text: &str, slash: usize) -> Option<(f64, usize)> {
    if text.as_bytes().get(slash) != Some(&b'/') {
        return None;
    }
    let end = digits_end(text, slash + 1);
    let value: f64 = text[slash + 1..end].parse().ok()?;
    (value > 0.0).then_some((value, end))
}

/// One of the typographic fractions of an inch.
fn vulgar_fraction(text: &str, at: usize) -> Option<(f64, usize)> {
    let c = text[at..].chars().next()?;
    let value = match c {
        '⅛' => 0.125,
        '¼' => 0.25,
        '⅜' => 0.375,
        '½' => 0.5,
        '⅝' => 0.625,
        '¾' => 0.75,
        '⅞' => 0.875,
        _ => return None,
    };
    Some((value, at + c.len_utf8()))
}

/// The end of the ASCII digits from `start`.
fn digits_end(text: &str, start: usize) -> usize {
    text.as_bytes()[start..]
        .iter()
        .position(|byte| !byte.is_ascii_digit())
        .map_or(text.len(), |count| start + count)
}

/// The end of the word from `start`.
fn word_end(text: &str, start: usize, end: usize) -> usize {
    text[start..end].find(char::is_whitespace).map_or(end, |length| start + length)
}

/// The end of the characters from `start` that may belong to numbers.
fn numeric_end(text: &str, start: usize, end: usize) -> usize {
    let part = |c: char| c.is_ascii_digit() || c.is_whitespace() || ".,_'/+-–−".contains(c);
    let run = text[start..end].trim_start_matches(part);
    let stop = end - run.len();
    start + text[start..stop].trim_end().len()
}
