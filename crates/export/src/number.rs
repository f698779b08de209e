//! Numbers as texts.

use wholestring_units::significant;

/// Significant digits of the numbers in WITSML: a tenth of a millimetre in 10 km.
pub const DIGITS: usize = 8;

/// A number to [`DIGITS`], without trailing zeros and without a power of ten; none if it is not
/// finite.
///
/// ```
/// use wholestring_export::number;
///
/// assert_eq!(number(1.0 / 3.0).as_deref(), Some("0.33333333"));
/// assert_eq!(number(-0.0).as_deref(), Some("0"));
/// assert_eq!(number(f64::NAN), None);
/// ```
pub fn number(value: f64) -> Option<String> {
    // Without negative zero.
    value.is_finite().then(|| (significant(value, DIGITS) + 0.0).to_string())
}
