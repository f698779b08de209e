//! Characters that change how a name is shown and are not seen themselves.
//!
//! A name with one of them reads as another: after U+202E, `gpj.toml` is shown as `lmot.jpg`, and a
//! zero-width space makes two names look equal (Unicode Technical Report 36, Trojan Source).

/// The first direction override or other invisible format character of a name.
///
/// A zero-width joiner or non-joiner between two letters outside ASCII is spelling, in Persian and
/// the scripts of India, and is not returned.
pub fn invisible(name: &str) -> Option<char> {
    let mut before = None;
    let mut letters = name.chars().peekable();
    while let Some(letter) = letters.next() {
        let joined = [before, letters.peek().copied()];
        let is_joiner = matches!(letter, '\u{200c}' | '\u{200d}');
        let is_spelling = is_joiner && joined.iter().all(|one| one.is_some_and(is_foreign_letter));
        if is_invisible(letter) && !is_spelling {
            return Some(letter);
        }
        before = Some(letter);
    }
    None
}

/// A sentence part on such a character: `the invisible character U+202E (right-to-left override)`.
pub fn described(letter: char) -> String {
    let name = match letter {
        '\u{ad}' => " (soft hyphen)",
        '\u{61c}' => " (Arabic letter mark)",
        '\u{200b}' => " (zero-width space)",
        '\u{200c}' => " (zero-width non-joiner)",
        '\u{200d}' => " (zero-width joiner)",
        '\u{200e}' => " (left-to-right mark)",
        '\u{200f}' => " (right-to-left mark)",
        '\u{2028}' => " (line separator)",
        '\u{2029}' => " (paragraph separator)",
        '\u{202a}' => " (left-to-right embedding)",
        '\u{202b}' => " (right-to-left embedding)",
        '\u{202c}' => " (end of a direction)",
        '\u{202d}' => " (left-to-right override)",
        '\u{202e}' => " (right-to-left override)",
        '\u{2060}' => " (word joiner)",
        '\u{2066}' => " (left-to-right isolate)",
        '\u{2067}' => " (right-to-left isolate)",
        '\u{2068}' => " (first strong isolate)",
        '\u{2069}' => " (end of an isolate)",
        '\u{feff}' => " (byte order mark)",
        _ => "",
    };
    format!("the invisible character U+{:04X}{name}", u32::from(letter))
}

fn is_foreign_letter(letter: char) -> bool {
    !letter.is_ascii() && (letter.is_alphanumeric() || is_virama(letter))
}

/// Signs of the scripts of India after which a joiner is written, which are no letters.
fn is_virama(letter: char) -> bool {
    matches!(u32::from(letter), 0x0900..=0x0dff) && !letter.is_alphanumeric()
}

/// Format characters (general category Cf of Unicode 16, without the visible ones), separators of
/// lines, fillers that are blank, and selectors of variants.
fn is_invisible(letter: char) -> bool {
    matches!(
        u32::from(letter),
        0xad
            | 0x34f
            | 0x61c
            | 0x115f..=0x1160
            | 0x17b4..=0x17b5
            | 0x180b..=0x180f
            | 0x200b..=0x200f
            | 0x2028..=0x202e
            | 0x2060..=0x206f
            | 0x3164
            | 0xfe00..=0xfe0f
            | 0xfeff
            | 0xffa0
            | 0xfff0..=0xfffb
            | 0x13430..=0x1345f
            | 0x1bca0..=0x1bca3
            | 0x1d173..=0x1d17a
            | 0xe0000..=0xe0fff
    )
}

#[cfg(test)]
mod tests {
    use super::{described, invisible};

    #[test]
    fn directions_and_invisible_characters_are_found() {
        let directions = ('\u{202a}'..='\u{202e}').chain('\u{2066}'..='\u{2069}');
        for letter in directions.chain("\u{ad}\u{200b}\u{200e}\u{2060}\u{feff}\u{e0041}".chars()) {
            assert_eq!(invisible(&format!("well{letter}7.toml")), Some(letter), "{letter:?}");
        }
        assert_eq!(invisible("a\u{200d}b"), Some('\u{200d}'));
        assert_eq!(invisible("\u{200c}چاه"), Some('\u{200c}'));
        let text = described('\u{202e}');
        assert_eq!(text, "the invisible character U+202E (right-to-left override)");
        assert_eq!(described('\u{e0041}'), "the invisible character U+E0041");
    }

    #[test]
    fn letters_of_every_script_are_kept() {
        // Persian and Hindi are spelt with joiners.
        for name in
            ["Bohrung 7 (neu)", "井", "скважина №3", "می\u{200c}روم", "क\u{94d}\u{200d}ष", "é"]
        {
            assert_eq!(invisible(name), None, "{name:?}");
        }
    }
}
