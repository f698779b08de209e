//! Look-up of a unit by its spelling.

use crate::Unit;

/// Maximum length of the spelling of a unit, bytes, with any spacing.
pub(crate) const LONGEST: usize = 64;

/// The bare form of a unit's spelling: no spaces, no sign between the factors of a product, plain
/// letters and digits for typographic ones.
///
/// `kN·m`, `kN*m`, `kN-m`, `kN m` and `kNm` become `kNm`; `°/30 m` becomes `deg/30m`.
pub(crate) fn bare(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for character in text.trim().replace(" per ", "/").chars() {
        match character {
            '·' | '⋅' | '∙' | '•' | '*' | '×' => plain.push('.'),
            '°' | 'º' | '˚' => plain.push_str("deg"),
            '²' => plain.push('2'),
            '³' => plain.push('3'),
            '”' | '″' | '“' => plain.push('"'),
            '’' | '′' | '‘' => plain.push('\''),
            '–' | '‐' | '‑' => plain.push('-'),
            '\u{a0}' | '\u{202f}' => plain.push(' '),
            other => plain.push(other),
        }
    }
    // A product sign is after a letter and before a letter or the end. Between digits, points and
    // spaces remain, so that `deg/30.5m` does not become `deg/305m`.
    let characters: Vec<char> = plain.chars().collect();
    let mut bare = String::with_capacity(plain.len());
    for (i, &character) in characters.iter().enumerate() {
        let printed = |c: &&char| !c.is_whitespace();
        let before = || characters[..i].iter().rev().find(printed).copied();
        let after = || characters[i + 1..].iter().find(printed).copied();
        let dropped = match character {
            '.' => {
                before().is_some_and(char::is_alphabetic)
                    && after().is_none_or(|c| c.is_alphabetic() || c == '/')
            }
            '-' => {
                before().is_some_and(char::is_alphabetic)
                    && after().is_some_and(char::is_alphabetic)
            }
            // `m^3` is `m3`; the power of `s^n` remains.
            '^' => after().is_some_and(|c| c.is_ascii_digit()),
            c if c.is_whitespace() => {
                !(before().is_some_and(|c| c.is_ascii_digit())
                    && after().is_some_and(|c| c.is_ascii_digit()))
            }
            _ => false,
        };
        if !dropped {
            bare.push(character);
        }
    }
    bare
}

/// The spellings of a dimension's units in their bare form, computed once, because a table of a
/// thousand cells looks up the unit of each in every dimension.
pub(crate) struct Spellings(Vec<(String, &'static Unit)>);

impl Spellings {
    pub(crate) fn of(units: &'static [Unit]) -> Self {
        let of_unit = |unit: &'static Unit| unit.spellings().map(move |s| (bare(s), unit));
        Self(units.iter().flat_map(of_unit).collect())
    }

    /// Returns the unit with this spelling: with its exact capitals, or else with any capitals if
    /// only one unit fits.
    pub(crate) fn find(&self, written: &str) -> Option<&'static Unit> {
        if written.len() > LONGEST {
            return None;
        }
        self.find_bare(&bare(written))
    }

    fn find_bare(&self, written: &str) -> Option<&'static Unit> {
        if let Some((_, unit)) = self.0.iter().find(|(spelling, _)| spelling == written) {
            return Some(unit);
        }
        let mut loose =
            self.0.iter().filter(|(spelling, _)| same_but_for_capitals(spelling, written));
        let (_, first) = loose.next()?;
        loose.all(|(_, other)| std::ptr::eq(*first, *other)).then_some(*first)
    }

    /// The unit before the words of [`DEPTHS`]: `ft` in `ftKB`.
    pub(crate) fn find_depth(&self, written: &str) -> Option<&'static Unit> {
        if written.len() > LONGEST {
            return None;
        }
        let bare = bare(written);
        let mut rest = bare.as_str();
        while let Some(shorter) = DEPTHS.iter().find_map(|word| {
            let (head, tail) = rest.split_at_checked(rest.len().checked_sub(word.len())?)?;
            (!head.is_empty() && tail.eq_ignore_ascii_case(word)).then_some(head)
        }) {
            rest = shorter;
            if let Some(unit) = self.find_bare(rest) {
                return Some(unit);
            }
        }
        None
    }
}

/// References and types of depths: measured depth, true vertical depth or along hole, from the
/// kelly bushing, rotary table, derrick floor or ground level. Depths below the sea are excluded,
/// because their zero differs.
const DEPTHS: &[&str] = &[
    "md", "tvd", "ah", "brkb", "rkb", "bkb", "kb", "brte", "rte", "brt", "rt", "bdf", "df", "bgl",
    "gl",
];

/// Whether spellings are equal except for capitals, with milli and mega separate: `KN` is `kN`, but
/// `mN` is not `MN`.
fn same_but_for_capitals(spelling: &str, written: &str) -> bool {
    if !spelling.eq_ignore_ascii_case(written) {
        return false;
    }
    let prefixed = ["n", "pa", "psi", "s", "g"]
        .iter()
        .any(|base| spelling.to_ascii_lowercase()[1..].starts_with(base));
    let first = |text: &str| text.chars().next();
    !(prefixed && matches!(first(spelling), Some('m' | 'M')) && first(spelling) != first(written))
}

#[cfg(test)]
mod tests {
    use super::bare;
    use crate::Dimension;

    #[test]
    fn depths_tell_from_where_they_are_measured() {
        let length = |text: &str| Dimension::Length.find_unit(text).map(|unit| unit.symbol);
        for text in ["ftKB", "ft KB", "FTKB", "ftRKB", "ftMD", "ft MD RT", "ftMDBRT", "ft TVD"] {
            assert_eq!(length(text), Some("ft"), "{text}");
        }
        for text in ["mKB", "mMD", "m MD", "m RT", "mTVDRKB", "mBRT", "mAH", "mGL"] {
            assert_eq!(length(text), Some("m"), "{text}");
        }
        assert_eq!(length("usftKB"), Some("usft"));
        // Words alone, depths below the sea, and texts before the words that are not units.
        for text in ["KB", "MD", "mSS", "ftMSL", "mTVDSS", "furlongKB", "cmd", "kbm"] {
            assert_eq!(length(text), None, "{text}");
        }
        assert_eq!(Dimension::Length.parse("1000 ftKB"), Ok(304.8));
        assert_eq!(Dimension::Diameter.find_unit("inKB"), None);
    }

    #[test]
    fn spellings_of_a_product_have_one_bare_form() {
        for text in ["kN.m", "kN·m", "kN*m", "kN-m", "kN m", "kNm", " kN . m "] {
            assert_eq!(bare(text), "kNm", "{text}");
        }
        assert_eq!(bare("°/30 m"), "deg/30m");
        assert_eq!(bare("deg per 100 ft"), "deg/100ft");
        assert_eq!(bare("kg/m³"), "kg/m3");
        assert_eq!(bare("kg/m^3"), "kg/m3");
        assert_eq!(bare("Pa.s^n"), "Pas^n");
        assert_eq!(bare("in."), "in");
        assert_eq!(bare("s.g."), "sg");
    }

    #[test]
    fn points_and_spaces_between_digits_stay() {
        assert_eq!(bare("deg/30.5m"), "deg/30.5m");
        assert_eq!(bare("deg/30 5m"), "deg/30 5m");
        assert_eq!(bare("kg/m-3"), "kg/m-3");
    }
}
