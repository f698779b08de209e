//! Printing of quantities.

use crate::Unit;

/// Significant digits shown to people.
const DIGITS: i32 = 5;

/// Value from which a power of ten is printed.
const LARGE: f64 = 1e7;

/// Value below which a power of ten is printed.
const SMALL: f64 = 1e-4;

/// The number with so many significant digits, the nearest one: without the rounding errors of
/// conversions and sums.
///
/// ```
/// use wholestring_units::significant;
///
/// assert_eq!(significant(0.1 + 0.2, 12), 0.3);
/// assert_eq!(significant(12_345.6, 3), 12_300.0);
/// assert!(significant(f64::NAN, 3).is_nan());
/// ```
pub fn significant(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.max(1) - 1).parse().unwrap_or(value)
}

/// Formats a bare number for people: at most seven digits, with a power of ten only if it is very
/// large or small.
///
/// ```
/// use wholestring_units::number_text;
///
/// assert_eq!(number_text(0.1 + 0.2), "0.3");
/// assert_eq!(number_text(2.1e11), "2.1e11");
/// ```
pub fn number_text(value: f64) -> String {
    let rounded = significant(value, 7);
    if rounded != 0.0 && !(1e-4..1e9).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

/// Formats the value in the unit for people.
pub(crate) fn for_people(unit: &Unit, si: f64) -> String {
    let value = unit.from_si(si);
    let size = value.abs();
    let number = if value == 0.0 {
        "0".to_owned()
    } else if !value.is_finite() {
        value.to_string()
    } else if (SMALL..LARGE).contains(&size) {
        let decimals = (DIGITS - 1 - libm::log10(size).floor() as i32).max(0) as usize;
        without_trailing_zeros(&format!("{value:.decimals$}")).to_owned()
    } else {
        let text = format!("{value:.*e}", DIGITS as usize - 1);
        match text.split_once('e') {
            Some((digits, power)) => format!("{}e{power}", without_trailing_zeros(digits)),
            None => text,
        }
    };
    format!("{number} {}", unit.symbol)
}

/// The text of a number without zeros after its last decimal.
///
/// ```
/// use wholestring_units::without_trailing_zeros;
///
/// assert_eq!(["1.500", "3.0", "300"].map(without_trailing_zeros), ["1.5", "3", "300"]);
/// ```
pub fn without_trailing_zeros(decimal: &str) -> &str {
    match decimal.contains('.') {
        true => decimal.trim_end_matches('0').trim_end_matches('.'),
        false => decimal,
    }
}

/// Returns the shortest text that reads back as the value; in `si_unit` if `unit` cannot represent
/// it.
pub(crate) fn exact(unit: &Unit, si_unit: &Unit, si: f64) -> String {
    match shortest(unit, si) {
        Some(number) => format!("{number} {}", unit.symbol),
        None => format!("{} {}", plain(si), si_unit.symbol),
    }
}

/// The shortest number in the unit that reads back as the value within one unit in the last place.
fn shortest(unit: &Unit, si: f64) -> Option<String> {
    let value = unit.from_si(si);
    // Seventeen digits always distinguish adjacent doubles; up to there, more digits only show the
    // rounding of the division.
    (14..=17).find_map(|digits| {
        let rounded = significant(value, digits);
        let back = unit.to_si(rounded);
        let near = back == si || back == si.next_up() || back == si.next_down();
        (near && back.is_finite()).then(|| plain(rounded))
    })
}

/// A double's own shortest digits, with a power of ten in place of many zeros.
fn plain(value: f64) -> String {
    let text = format!("{value:?}");
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}
