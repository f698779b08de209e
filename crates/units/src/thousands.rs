//! Numbers with separated thousands.

/// A number with separated thousands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parted {
    pub(crate) value: f64,
    /// Its end in the text.
    pub(crate) end: usize,
    /// Whether its separator may also be a decimal mark: `1,500`.
    pub(crate) is_unsure: bool,
}

/// Parses a whole number or decimal at `start` whose thousands are separated by the same sign
/// throughout: a comma, a blank, an apostrophe or an underscore before each three digits.
pub(crate) fn parted(text: &str, start: usize) -> Option<Parted> {
    let digits = |from: usize| {
        let rest = &text.as_bytes()[from..];
        rest.iter().take_while(|byte| byte.is_ascii_digit()).count()
    };
    let first = digits(start);
    // "0,250" has no thousands.
    if !(1..=3).contains(&first) || text[start..].starts_with('0') {
        return None;
    }
    let mut end = start + first;
    let sign = text[end..].chars().next().filter(|c| is_sign(*c))?;
    let mut groups = 0;
    while text[end..].starts_with(sign) && digits(end + sign.len_utf8()) == 3 {
        end += sign.len_utf8() + 3;
        groups += 1;
    }
    // Groups of other than three digits are not thousands.
    let goes_on = text[end..].strip_prefix(sign);
    if groups == 0 || goes_on.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) {
        return None;
    }
    let mut plain: String = text[start..end].chars().filter(char::is_ascii_digit).collect();
    let mut is_unsure = sign == ',' && groups == 1;
    if text[end..].starts_with('.') {
        let decimals = digits(end + 1);
        plain.push_str(&text[end..end + 1 + decimals]);
        end += 1 + decimals;
        is_unsure = false;
    }
    // A fraction, an exponent or another mark is not a number with thousands.
    if text[end..].starts_with(['/', ',', '.', '_', '-', '–']) {
        return None;
    }
    Some(Parted { value: plain.parse().ok()?, end, is_unsure })
}

fn is_sign(c: char) -> bool {
    matches!(c, ',' | ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}' | '\'' | '’' | '_')
}
