//! Numbers in cells: meaning of their commas and points.

/// Numbers that databases and loggers write for missing measurements. No sensor of a rig measures
/// them.
const NULLS: [f64; 12] = [
    -999.0,
    -999.25,
    -999.99,
    -8888.0,
    -9999.0,
    -9999.25,
    -99_999.0,
    -99_999.25,
    -999_999.0,
    -999_999.25,
    -32_767.0,
    -32_768.0,
];

/// Whether a number stands for a missing measurement, such as -999.25, in whatever unit.
pub fn is_null(number: f64) -> bool {
    NULLS.contains(&number)
}

/// Words for missing numbers.
const NULL_WORDS: [&str; 10] =
    ["n/a", "na", "n.a.", "nan", "nil", "null", "none", "#n/a", "nr", "not recorded"];

/// Whether a text is a word or dashes for a missing number, or empty.
pub(crate) fn is_null_word(text: &str) -> bool {
    text.chars().all(|c| "-–— .".contains(c))
        || NULL_WORDS.iter().any(|word| text.eq_ignore_ascii_case(word))
}

/// Meaning of commas and points in the numbers of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    /// `1500.5`, or `1,500.5` with thousands.
    Point,
    /// `1500,5`, or `1.500,5` with thousands.
    Comma,
}

/// Reason why a text is not a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fault {
    NotANumber,
    NotFinite,
}

/// Determines the style of numbers; `Err` contains the first number that remains ambiguous.
///
/// A separator of groups of three digits may be either. One unambiguous number decides for the
/// whole table.
pub(crate) fn style<'a>(numbers: impl Iterator<Item = &'a str>) -> Result<Style, &'a str> {
    let (mut point, mut comma) = (false, false);
    let (mut point_or_thousands, mut comma_or_thousands) = (None, None);
    for number in numbers.filter(|number| number.contains([',', '.'])) {
        let fits_point = read(number, Style::Point).is_ok();
        let fits_comma = read(number, Style::Comma).is_ok();
        match (fits_point, fits_comma) {
            (true, false) => point = true,
            (false, true) => comma = true,
            (true, true) if number.contains(',') => {
                comma_or_thousands.get_or_insert(number);
            }
            (true, true) => {
                point_or_thousands.get_or_insert(number);
            }
            (false, false) => {}
        }
    }
    match (point, comma) {
        // If there are both, the numbers with commas are refused at their own places.
        (true, _) => Ok(Style::Point),
        (false, true) => Ok(Style::Comma),
        // `1,500` and `3.125` in one table: angles are too small for thousands, so that points are
        // decimals.
        (false, false) => match (point_or_thousands, comma_or_thousands) {
            (_, None) | (Some(_), Some(_)) => Ok(Style::Point),
            (None, Some(number)) => Err(number),
        },
    }
}

/// Reads a number in a style.
pub(crate) fn read(text: &str, style: Style) -> Result<f64, Fault> {
    let text = without_marks(text).replace('−', "-");
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(&text);
    if ["nan", "inf", "infinity"].iter().any(|name| unsigned.eq_ignore_ascii_case(name)) {
        return Err(Fault::NotFinite);
    }
    let (decimal, thousands) = match style {
        Style::Point => ('.', ','),
        Style::Comma => (',', '.'),
    };
    let (mantissa, exponent) = match unsigned.find(['e', 'E']) {
        Some(at) => unsigned.split_at(at),
        None => (unsigned, ""),
    };
    let (whole, fraction) = mantissa.split_once(decimal).unwrap_or((mantissa, ""));
    let whole = without_groups(whole, &[thousands, ' ', '\u{a0}', '\u{202f}', '\'', '’']);
    let mut number = String::with_capacity(text.len());
    number.push_str(&text[..text.len() - unsigned.len()]);
    number.push_str(&whole);
    number.push('.');
    number.push_str(fraction);
    number.push_str(exponent);
    let plain = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    if !number.chars().all(plain) {
        return Err(Fault::NotANumber);
    }
    match number.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(Fault::NotFinite),
        Err(_) => Err(Fault::NotANumber),
    }
}

/// Signs that reports put after a number to refer to a remark.
const MARKS: [char; 5] = ['*', '!', '#', '†', '‡'];

/// A cell's text without the marks after its number.
pub(crate) fn without_marks(text: &str) -> &str {
    text.trim().trim_end_matches(MARKS).trim_end()
}

/// Parses a distance with its side, `12.5 N`, `3 W`: its number, and whether the side is opposite
/// to north or east.
pub(crate) fn sided(text: &str) -> Option<(&str, bool)> {
    let text = without_marks(text);
    let is_other = match text.chars().next_back()? {
        'N' | 'E' => false,
        'S' | 'W' => true,
        _ => return None,
    };
    Some((text[..text.len() - 1].trim_end(), is_other))
}

/// Reads a number in a style, or a proper fraction with or without a whole number before it:
/// `8 1/2`, `8-1/2`, `8½`, `5/8`.
pub(crate) fn read_or_fraction(text: &str, style: Style) -> Result<f64, Fault> {
    let fault = match read(text, style) {
        Ok(number) => return Ok(number),
        Err(fault) => fault,
    };
    let is_fraction = text.contains(['/', '⅛', '¼', '⅜', '½', '⅝', '¾', '⅞']);
    // `8/1` is the remainder of a date.
    let improper = text.split_once('/').is_some_and(|(top, bottom)| {
        let parsed = (top.trim().parse::<u32>(), bottom.trim().parse::<u32>());
        matches!(parsed, (Ok(top), Ok(bottom)) if top >= bottom)
    });
    if !is_fraction || improper {
        return Err(fault);
    }
    // The reader of quantities parses fractions.
    let read = wholestring_units::Dimension::Length.read(&format!("{text} m"));
    read.map(|written| written.number).map_err(|_| fault)
}

/// Whether it is a number in one style or the other.
pub(crate) fn is_number(text: &str) -> bool {
    read(text, Style::Point).is_ok() || read(text, Style::Comma).is_ok()
}

/// Whether two adjacent cells look like one number that was cut at its separator of thousands: `1`
/// and `000`, `-12` and `500.5`.
pub(crate) fn is_cut_at_thousands(before: &str, rest: &str) -> bool {
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let before = before.trim_start_matches(['+', '-', '−']);
    let (group, fraction) = rest.split_once(['.', ',']).unwrap_or((rest, ""));
    let leads = (1..=3).contains(&before.len()) && !before.starts_with('0') && digits(before);
    leads && group.len() == 3 && digits(group) && digits(fraction)
}

/// Digits without the signs between groups of three; the text itself if it has no such groups.
fn without_groups(whole: &str, separators: &[char]) -> String {
    let Some(separator) = whole.chars().find(|c| separators.contains(c)) else {
        return whole.to_owned();
    };
    let groups: Vec<&str> = whole.split(separator).collect();
    let digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let leads = (1..=3).contains(&groups[0].len()) && !groups[0].starts_with('0');
    if leads
        && groups.iter().all(|group| digits(group))
        && groups[1..].iter().all(|group| group.len() == 3)
    {
        groups.concat()
    } else {
        whole.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::{Fault, Style, read, read_or_fraction, style};

    #[test]
    fn fractions_are_read_and_what_is_left_of_dates_is_not() {
        let fraction = |text| read_or_fraction(text, Style::Point);
        for text in ["8 1/2", "8-1/2", "8½", "8 ½", "8.5", "8–1/2"] {
            assert_eq!(fraction(text), Ok(8.5), "{text}");
        }
        assert_eq!(fraction("5/8"), Ok(0.625));
        assert_eq!(read_or_fraction("8,5", Style::Comma), Ok(8.5));
        for text in ["8/1", "8/8", "1/2/2026", "8-Jan", "8 1/0", "", "/", "½½", "8 1/2 x 2"] {
            assert_eq!(fraction(text), Err(Fault::NotANumber), "{text}");
        }
    }

    #[test]
    fn numbers_are_read_in_their_style() {
        let point = |text| read(text, Style::Point);
        let comma = |text| read(text, Style::Comma);
        assert_eq!(point("1,500.25"), Ok(1500.25));
        assert_eq!(point("-1,234,567"), Ok(-1_234_567.0));
        assert_eq!(point("1 500.5"), Ok(1500.5));
        assert_eq!(point(".5"), Ok(0.5));
        assert_eq!(point("5."), Ok(5.0));
        assert_eq!(point("1e3"), Ok(1000.0));
        assert_eq!(comma("1.500,25"), Ok(1500.25));
        assert_eq!(comma("−0,5"), Ok(-0.5));
        for text in ["", ".", "-", "1,50", "0,500", "1,5000", "1.2.3", "1e", "e5", "abc", "5m"] {
            assert_eq!(point(text), Err(Fault::NotANumber), "{text}");
        }
        for text in ["NaN", "-inf", "Infinity", "1e999"] {
            assert_eq!(point(text), Err(Fault::NotFinite), "{text}");
        }
    }

    #[test]
    fn one_number_settles_the_style() {
        assert_eq!(style(["1,500", "0.5"].into_iter()), Ok(Style::Point));
        assert_eq!(style(["1,500.0", "2,000"].into_iter()), Ok(Style::Point));
        assert_eq!(style(["1,500", "0,5"].into_iter()), Ok(Style::Comma));
        assert_eq!(style(["1.500", "0,5"].into_iter()), Ok(Style::Comma));
        assert_eq!(style(["0,000", "1,500"].into_iter()), Ok(Style::Comma));
        assert_eq!(style(["30.125", "1500"].into_iter()), Ok(Style::Point));
        assert_eq!(style(["30,125", "1500"].into_iter()), Err("30,125"));
        assert_eq!(style(["30", "1500", "x,y"].into_iter()), Ok(Style::Point));
    }
}
