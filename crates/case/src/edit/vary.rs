//! Values of a key in a sweep, one after the other.

use wholestring_config::{diagnostic::Report, prelude::*};
use wholestring_units::significant;

use crate::edit::overrides::{Override, Quote};

/// A `--vary KEY=VALUES`: a key and its values.
///
/// The key is any key of `--set`. The values are separated by commas; each is a value in the form
/// of `--set`, or a range `FROM..TO/STEP` of numbers with the same unit, which always includes TO.
///
/// ```
/// use wholestring_case::Variation;
///
/// let depths = Variation::read_all(&["bit_depth=300m..1000m/300m,2km".into()])?.remove(0);
/// let values: Vec<_> = depths.values.iter().map(|value| value.value.as_str()).collect();
/// assert_eq!(values, ["300m", "600m", "900m", "1000m", "2km"]);
///
/// let no_step = Variation::read_all(&["rpm=60..120".into()]).unwrap_err();
/// assert!(no_step.render(false).contains("a range needs a step"));
/// # Ok::<(), wholestring_case::Report>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variation {
    /// Dotted or short key.
    pub key: String,
    /// The values in their order, each as an override of the key.
    pub values: Vec<Override>,
}

/// Maximum number of values of one key, in a range or in all.
const MAX_VALUES: f64 = 10_000.0;

/// Maximum number of characters of a range.
const LONGEST: usize = 500;

/// Form of a range.
const RANGE: &str = "such as 300m..4305m/300m";

impl Variation {
    /// Reads the arguments of all `--vary`.
    ///
    /// # Errors
    /// A report of every mistake that can be detected without a case, with its place underlined.
    pub fn read_all(arguments: &[String]) -> Result<Vec<Self>, Report> {
        let mut reader = Reader::default();
        let mut variations: Vec<Self> = Vec::new();
        for argument in arguments {
            let text = Text::new(argument, &mut reader);
            let Some(variation) = text.read(&mut reader) else {
                continue;
            };
            if variations.iter().any(|other| other.key == variation.key) {
                let message = format!("`{}` is varied twice", short(&variation.key));
                let place = text.place(text.start, text.start + variation.key.len());
                Diagnostic::error(message)
                    .at(place, "it is already defined above")
                    .help("give all values in one --vary, parted by commas")
                    .report(&mut reader);
            }
            variations.push(variation);
        }
        if reader.has_errors() { Err(reader.into_report()) } else { Ok(variations) }
    }
}

/// Reads the quantities of an option of a front end, such as `--weight 20kN..120kN/20kN`: one,
/// several separated by commas, or ranges `FROM..TO/STEP` in the form of a [`Variation`], in a
/// dimension, SI.
///
/// ```
/// use wholestring_case::read_values;
/// use wholestring_units::{Dimension, significant};
///
/// let metres = read_values("--depth", "300m..1000m/300m", Dimension::Length)?;
/// assert_eq!(metres, [300.0, 600.0, 900.0, 1000.0]);
/// let mistaken = read_values("--depth", "300m,2kN", Dimension::Length).unwrap_err();
/// assert!(mistaken.render(false).contains("`2kN`"));
/// # Ok::<(), wholestring_case::Report>(())
/// ```
///
/// # Errors
/// A report of a mistake, underlined.
pub fn read_values(option: &str, values: &str, dimension: Dimension) -> Result<Vec<f64>, Report> {
    let mut reader = Reader::default();
    let text = Text::after(&format!("{option} "), values, &mut reader);
    let found = text.values(option, values, &mut reader);
    let mut numbers = Vec::new();
    for value in found.iter().flat_map(Variation::bare_values) {
        match dimension.parse(value) {
            Ok(number) if number.is_finite() => numbers.push(number),
            Ok(_) => {}
            Err(error) => {
                let place = text.place(text.start, text.quoted.len());
                let message = format!("`{}` is no {}", short(value), dimension.name());
                Diagnostic::error(message).at(place, error.to_string()).report(&mut reader);
                break;
            }
        }
    }
    if reader.has_errors() { Err(reader.into_report()) } else { Ok(numbers) }
}

impl Variation {
    /// Returns a key with these values, each in the form of `--set`. They may be equal, and there
    /// may be any number of them, because samples are.
    pub fn of_values(key: &str, values: &[String]) -> Self {
        let value =
            |value: &String| Override::quoted(key, value, Quote::of_value("vary", key, value));
        Self { key: key.to_owned(), values: values.iter().map(value).collect() }
    }

    /// Returns the values without quotes.
    pub fn bare_values(&self) -> impl Iterator<Item = &str> {
        self.values.iter().map(Override::bare)
    }

    /// Adds a value, or those of a range, from its text and its quotation. Returns whether it is
    /// valid.
    pub fn take(
        &mut self,
        [says, written]: [&str; 2],
        quote: Quote,
        place: Span,
        reader: &mut Reader,
    ) -> bool {
        let values = match expand(says) {
            Ok(None) => vec![Override::quoted(&self.key, written, quote)],
            Ok(Some(values)) => {
                let quote = Quote { verbatim: false, ..quote };
                let value = |value: &String| Override::quoted(&self.key, value, quote.clone());
                values.iter().map(value).collect()
            }
            Err((message, label)) => {
                reader.report(Diagnostic::error(message).at(place, label));
                return false;
            }
        };
        // Checked before they are compared with each other, because the time of that grows with the
        // square of their number.
        if (self.values.len() + values.len()) as f64 > MAX_VALUES {
            let message = format!("`{}` is given more than {MAX_VALUES} values", short(&self.key));
            reader.report(Diagnostic::error(message).at(place, "expected fewer"));
            return false;
        }
        for value in values {
            if self.values.iter().any(|other| other.value == value.value) {
                let message = format!("`{}` is given twice", short(&value.value));
                reader.report(Diagnostic::error(message).at(place, "already given before"));
                return false;
            }
            self.values.push(value);
        }
        true
    }
}

/// An argument in the form quoted by diagnostics.
struct Text {
    source: usize,
    quoted: String,
    /// Offset of the argument in the quotation.
    start: usize,
}

impl Text {
    fn new(argument: &str, reader: &mut Reader) -> Self {
        Self::after("--vary ", argument, reader)
    }

    fn after(prefix: &str, argument: &str, reader: &mut Reader) -> Self {
        let quoted = format!("{prefix}{argument}");
        Self { source: reader.add_source(COMMAND_LINE, &quoted), quoted, start: prefix.len() }
    }

    fn place(&self, start: usize, end: usize) -> Span {
        Span { source: self.source, start, end }
    }

    fn read(&self, reader: &mut Reader) -> Option<Variation> {
        let argument = &self.quoted[self.start..];
        let (key, values) = match argument.split_once('=') {
            Some((key, values)) if !key.trim().is_empty() && !values.trim().is_empty() => {
                (key, values)
            }
            _ => {
                let message = format!("`{}` is not KEY=VALUES", short(argument));
                let place = self.place(self.start, self.quoted.len());
                return Diagnostic::error(message)
                    .at(place, "expected such as friction=0.2,0.3")
                    .help(format!("a range is FROM..TO/STEP, {RANGE}"))
                    .refuse(reader);
            }
        };
        self.values(key, values, reader)
    }

    /// Returns the values at the end of the text, for a key at its beginning.
    fn values(&self, key: &str, values: &str, reader: &mut Reader) -> Option<Variation> {
        let key_start = self.start + key.len() - key.trim_start().len();
        let key = key.trim();
        let key_end = (key_start + key.len()).min(self.quoted.len());
        let mut variation = Variation { key: key.to_owned(), values: Vec::new() };
        let values_start = self.quoted.len() - values.len();
        let mut valid = true;
        for (offset, element) in elements(values) {
            let start = values_start + offset + element.len() - element.trim_start().len();
            let element = element.trim();
            let quote = Quote {
                name: COMMAND_LINE.into(),
                text: self.quoted.as_str().into(),
                key: key_start.min(key_end)..key_end,
                value: start..start + element.len(),
                verbatim: true,
            };
            let place = self.place(start, start + element.len());
            valid &= variation.take([element, element], quote, place, reader);
        }
        valid.then_some(variation)
    }
}

/// Returns the parts of a text between its commas, with their offsets; commas within brackets and
/// quotes do not separate.
fn elements(text: &str) -> Vec<(usize, &str)> {
    let mut parts = Vec::new();
    let (mut start, mut depth, mut quote) = (0, 0_usize, None);
    for (at, letter) in text.char_indices() {
        match (quote, letter) {
            (Some(open), _) if open == letter => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(letter),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth = depth.saturating_sub(1),
            (None, ',') if depth == 0 => {
                parts.push((start, &text[start..at]));
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push((start, &text[start..]));
    parts
}

/// A message and a label.
type Mistake = (String, String);

/// Returns the values of a range; `None` if the element is not a range.
fn expand(element: &str) -> Result<Option<Vec<String>>, Mistake> {
    if element.is_empty() {
        return Err(("a value is missing between two commas".into(), "expected a value".into()));
    }
    let Some((from, rest)) = element.split_once("..") else {
        return Ok(None);
    };
    // An element that does not begin like a number, such as `../survey.csv`, is not a range.
    let Some(from) = Quantity::read(from) else {
        return Ok(None);
    };
    // Every slash may separate the end from the step: the time of thousands of them grows with the
    // square of their number.
    if element.len() > LONGEST {
        return Err((
            format!("a range is longer than {LONGEST} characters"),
            format!("expected FROM..TO/STEP, {RANGE}"),
        ));
    }
    let parted: Vec<[Option<Quantity<'_>>; 2]> = rest
        .match_indices('/')
        .map(|(at, _)| [&rest[..at], &rest[at + 1..]].map(Quantity::read))
        .collect();
    // A unit may contain a slash too: `10 m/h..30 m/h/5 m/h`.
    let alike = parted.iter().find_map(|pair| match pair {
        [Some(to), Some(step)] if to.unit == from.unit && step.unit == from.unit => {
            Some((to.number, step.number))
        }
        _ => None,
    });
    let Some((to, step)) = alike else {
        let expected = format!("expected FROM..TO/STEP, {RANGE}");
        let any = |pair: &[Option<Quantity<'_>>; 2]| matches!(pair, [Some(_), Some(_)]);
        return Err(if parted.iter().any(any) {
            (
                "the parts of a range have one unit".into(),
                format!("expected the same unit three times, {RANGE}"),
            )
        } else if rest.trim().is_empty() || Quantity::read(rest).is_none() {
            ("a range needs an end".into(), expected)
        } else {
            ("a range needs a step".into(), expected)
        });
    };
    if step <= 0.0 {
        return Err(("the step of a range is more than zero".into(), "it would never end".into()));
    }
    // The number of whole steps, with a tolerance for the rounding of decimal fractions.
    let steps = ((to - from.number).abs() / step + 1e-9).floor();
    if steps >= MAX_VALUES {
        return Err((
            format!("this range has {} values", steps + 1.0),
            format!("expected at most {MAX_VALUES}"),
        ));
    }
    let toward = step.copysign(to - from.number);
    // So that 0.1 + 2 × 0.1 gives 0.3.
    let number = |i: u64| significant(libm::fma(toward, i as f64, from.number), DIGITS);
    let mut numbers: Vec<f64> = (0..=steps as u64).map(number).collect();
    let last = numbers[numbers.len() - 1];
    if (last - to).abs() <= 1e-9 * step {
        numbers.pop();
    }
    numbers.push(to);
    let unit = from.unit;
    let blank = if from.apart { " " } else { "" };
    Ok(Some(numbers.iter().map(|number| format!("{number}{blank}{unit}")).collect()))
}

/// Digits of the numbers of a range.
const DIGITS: usize = 12;

/// A number and its unit as written.
pub(crate) struct Quantity<'a> {
    pub(crate) number: f64,
    pub(crate) unit: &'a str,
    /// Whether a blank separates them.
    pub(crate) apart: bool,
}

impl<'a> Quantity<'a> {
    pub(crate) fn read(text: &'a str) -> Option<Self> {
        let text = text.trim();
        let end = text
            .char_indices()
            .map(|(at, letter)| at + letter.len_utf8())
            // The longest prefix that is a number: `5e` of `5e3` is not one.
            .rfind(|end| text[..*end].parse::<f64>().is_ok_and(f64::is_finite))?;
        let rest = &text[end..];
        Some(Self {
            number: text[..end].parse().ok()?,
            unit: rest.trim(),
            apart: rest.starts_with(' '),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(argument: &str) -> Vec<String> {
        let variations = Variation::read_all(&[argument.to_owned()]).expect(argument);
        let values = variations[0].values.iter();
        values.map(|value| value.value.clone()).collect()
    }

    #[test]
    fn lists_and_ranges() {
        for (argument, expected) in [
            ("a=1", &["1"][..]),
            (" a = 1 , 2m ", &["1", "2m"]),
            ("a=0.1..0.4/0.1", &["0.1", "0.2", "0.3", "0.4"]),
            ("a=0.4..0.1/0.1", &["0.4", "0.3", "0.2", "0.1"]),
            ("a=300m..1000m/300m", &["300m", "600m", "900m", "1000m"]),
            ("a=-1..1/1", &["-1", "0", "1"]),
            ("a=5..5/1", &["5"]),
            ("a=1..1.5/1", &["1", "1.5"]),
            ("a=1e3..3e3/1e3", &["1000", "2000", "3000"]),
            ("a=10 m/h..20 m/h/5 m/h", &["10 m/h", "15 m/h", "20 m/h"]),
            ("a=1deg/30m..2deg/30m/0.5deg/30m", &["1deg/30m", "1.5deg/30m", "2deg/30m"]),
            ("a=1,5..6/1,9", &["1", "5", "6", "9"]),
            ("a=[1, 2],\"x,y\"", &["[1, 2]", "\"x,y\""]),
            ("a=../one.csv,../two.csv", &["../one.csv", "../two.csv"]),
            ("a=drill,slide", &["drill", "slide"]),
        ] {
            assert_eq!(values(argument), expected, "{argument}");
        }
    }

    /// Whatever the step, a range begins at FROM, ends at TO and is monotonic.
    #[test]
    fn a_range_has_both_its_ends() {
        for tenths in 1..40 {
            for step in 1..30 {
                let argument = format!("a=0.1..{}/{}", tenths as f64 / 10.0, step as f64 / 100.0);
                let numbers: Vec<f64> =
                    values(&argument).iter().map(|value| value.parse().unwrap()).collect();
                assert_eq!(numbers[0], 0.1, "{argument}");
                assert_eq!(numbers[numbers.len() - 1], tenths as f64 / 10.0, "{argument}");
                assert!(numbers.is_sorted_by(|a, b| a < b), "{argument}: {numbers:?}");
            }
        }
    }

    /// Excessive lengths are refused before the quadratic time of reading them is spent.
    #[test]
    fn what_is_far_too_long_is_refused() {
        let refused = |argument: String| {
            let report = Variation::read_all(&[argument]).expect_err("a mistake");
            report.render(false)
        };
        let slashes = refused(format!("a=1..2{}", "/1".repeat(50_000)));
        assert!(slashes.contains("a range is longer than 500 characters"));
        let dots = refused(format!("a=1{}", "..1".repeat(50_000)));
        assert!(dots.contains("a range is longer than 500 characters"));
        let values: Vec<String> = (0..=10_000).map(|value| value.to_string()).collect();
        let many = refused(format!("a={}", values.join(",")));
        assert!(many.contains("`a` is given more than 10000 values"));
        let many = refused("a=0..5000/1,5001..11000/1".into());
        assert!(many.contains("`a` is given more than 10000 values"));
        // The maximum that is allowed.
        let all = Variation::read_all(&["a=1..10000/1".into()]).expect("a range");
        assert_eq!(all[0].values.len(), 10_000);
    }
}
