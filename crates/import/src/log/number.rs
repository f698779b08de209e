//! Numbers of logs, read fast.

/// Meaning of decimal points and commas within numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Marks {
    /// Decimal point; commas group thousands: `12,030.5`.
    Point,
    /// Decimal comma; points group thousands: `12.030,5`.
    Comma,
    /// Either is a decimal mark; thousands are not grouped.
    Either,
}

/// Powers of ten that a double represents exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Parses a number with a decimal point, rounded correctly; `None` for any other text.
///
/// Digits that make less than 2^53 and a power of ten up to 22 are both exact, so that their
/// quotient is rounded once; longer numbers use the standard library.
pub(crate) fn number(text: &[u8]) -> Option<f64> {
    let (negative, digits) = match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    };
    let mut whole: u64 = 0;
    let mut seen = 0;
    let mut decimals = None;
    for (at, &byte) in digits.iter().enumerate() {
        match byte {
            b'0'..=b'9' if seen < 18 => {
                whole = whole * 10 + u64::from(byte - b'0');
                seen += 1;
            }
            b'.' if decimals.is_none() => decimals = Some(digits.len() - at - 1),
            _ => return long(text),
        }
    }
    let decimals = decimals.unwrap_or(0);
    if seen == 0 || whole >= 1 << 53 || decimals >= POWERS.len() {
        return long(text);
    }
    let value = whole as f64 / POWERS[decimals];
    Some(if negative { -value } else { value })
}

fn long(text: &[u8]) -> Option<f64> {
    let plain = |b: &u8| matches!(b, b'0'..=b'9' | b'+' | b'-' | b'.' | b'e' | b'E');
    if !text.iter().all(plain) {
        return None;
    }
    std::str::from_utf8(text).ok()?.parse().ok().filter(|value: &f64| value.is_finite())
}

/// Parses a number with the given marks.
pub(crate) fn marked(text: &[u8], marks: Marks) -> Option<f64> {
    let comma = text.contains(&b',');
    match marks {
        Marks::Point | Marks::Either if !comma => number(text),
        Marks::Either => {
            let one = text.iter().filter(|b| matches!(b, b',' | b'.')).count() == 1;
            one.then(|| plain(text, b',', 0)).flatten()
        }
        // "12,030" alone might be 12.03.
        Marks::Point if !text.contains(&b'.') => None,
        Marks::Point => grouped(text, b'.', b','),
        Marks::Comma => grouped(text, b',', b'.'),
    }
}

/// Determines the marks of numbers in a file whose columns are not separated by commas: one
/// unambiguous number decides for all.
pub(crate) fn marks<'a>(numbers: impl Iterator<Item = &'a [u8]>) -> Marks {
    let mut unsure_comma = false;
    let mut point = false;
    for text in numbers {
        let last = text.iter().rposition(|b| matches!(b, b',' | b'.'));
        let Some(last) = last else { continue };
        if !text.iter().all(|b| b.is_ascii_digit() || b",.-+".contains(b)) {
            continue;
        }
        // "12,030" may be either.
        let marks = text.iter().filter(|b| matches!(b, b',' | b'.'));
        let sure = text.len() - last != 4 || marks.clone().any(|mark| *mark != text[last]);
        match (text[last], sure) {
            (b',', true) => return Marks::Comma,
            (b',', false) => unsure_comma = true,
            (_, true) => point = true,
            (_, false) => {}
        }
    }
    if unsure_comma && !point { Marks::Comma } else { Marks::Point }
}

/// Parses a number with its thousands grouped in threes.
fn grouped(text: &[u8], decimal: u8, group: u8) -> Option<f64> {
    let mut whole = text.split(|b| *b == decimal);
    let before = whole.next()?;
    if before.contains(&group) {
        let mut groups = before.split(|b| *b == group);
        let first = groups.next()?.iter().filter(|b| b.is_ascii_digit()).count();
        if !(1..=3).contains(&first) || !groups.all(|group| group.len() == 3) {
            return None;
        }
    }
    let after_is_plain = whole.next().is_none_or(|after| !after.contains(&group));
    (after_is_plain && whole.next().is_none()).then(|| plain(text, decimal, group)).flatten()
}

/// Returns the number with a decimal point and without the grouping mark.
fn plain(text: &[u8], decimal: u8, group: u8) -> Option<f64> {
    if text.len() > 40 {
        return None;
    }
    let ungrouped = text.iter().filter(|b| **b != group);
    let plain: Vec<u8> = ungrouped.map(|b| if *b == decimal { b'.' } else { *b }).collect();
    number(&plain)
}

/// Whether a text denotes a missing value.
pub(crate) fn is_nothing(text: &[u8]) -> bool {
    let words: &[&[u8]] = &[
        b"", b"nan", b"null", b"n/a", b"#n/a", b"na", b"nil", b"none", b"-", b"--", b"---",
        b"no data", b"absent", b"1.#qnan", b"-1.#ind", b"nodata", b"bad", b"*", b"****",
    ];
    text.len() <= 8 && words.iter().any(|word| text.eq_ignore_ascii_case(word))
}

#[cfg(test)]
mod tests {
    use super::{Marks, marked, number};

    #[test]
    fn numbers_are_those_of_the_standard_library() {
        for text in [
            "0",
            "-0.0",
            "1",
            "-999.25",
            "12030.125",
            "+7",
            "1e3",
            "-1.5E-3",
            "0.1",
            "123456.789",
            "9007199254740993",
            "0.30000000000000004",
            "179769313486231570000",
            "5.",
            ".5",
            "123456789012345678901234567890",
            "0.00000000000000000000000000001",
        ] {
            assert_eq!(number(text.as_bytes()), Some(text.parse().unwrap()), "{text}");
        }
        for text in ["", "-", ".", "1.2.3", "7.020101130.188", "inf", "NaN", "1,5", "0x1", "1e999"]
        {
            assert_eq!(number(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn a_number_that_is_sure_tells_the_marks() {
        let marks = |texts: &[&str]| super::marks(texts.iter().map(|text| text.as_bytes()));
        assert_eq!(marks(&["12", "12,030", "62,1"]), Marks::Comma);
        assert_eq!(marks(&["12.030,5"]), Marks::Comma);
        assert_eq!(marks(&["12,030", "62.1"]), Marks::Point);
        assert_eq!(marks(&["12,030.5"]), Marks::Point);
        assert_eq!(marks(&["12,030"]), Marks::Comma);
        assert_eq!(marks(&["12.030", "a,b"]), Marks::Point);
    }

    #[test]
    fn marks_part_decimals_or_thousands() {
        let read = |text: &str, marks| marked(text.as_bytes(), marks);
        assert_eq!(read("12,030.5", Marks::Point), Some(12030.5));
        assert_eq!(read("1,212,030.5", Marks::Point), Some(1212030.5));
        assert_eq!(read("12,03.5", Marks::Point), None);
        assert_eq!(read("12,030", Marks::Point), None);
        assert_eq!(read("12.030,5", Marks::Comma), Some(12030.5));
        assert_eq!(read("12.030", Marks::Comma), Some(12030.0));
        assert_eq!(read("62.1", Marks::Comma), None);
        assert_eq!(read("-62,1", Marks::Comma), Some(-62.1));
        assert_eq!(read("123,420", Marks::Either), Some(123.42));
        assert_eq!(read("123.420", Marks::Either), Some(123.42));
        assert_eq!(read("1,234.5", Marks::Either), None);
    }
}
