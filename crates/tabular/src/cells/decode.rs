//! From bytes to text.

/// Decodes a file in UTF-8 or UTF-16 with a byte order mark, UTF-8 without one, Windows-1251 or
/// Windows-1252 (of which the part that matters here is Latin-1). `None` if the bytes are not text.
pub(crate) fn text(bytes: &[u8]) -> Option<String> {
    let text = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => std::str::from_utf8(rest).ok()?.to_owned(),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?,
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?,
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => single_bytes(bytes),
        },
    };
    // A form feed separates the pages of a report; an old end-of-file mark may end it.
    let binary = |c: char| c.is_control() && !"\t\n\r\u{c}\u{1a}\u{85}".contains(c);
    (!text.contains(binary)).then_some(text)
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let units: Vec<u16> = pairs.iter().map(|&pair| unit(pair)).collect();
    if rest.is_empty() { String::from_utf16(&units).ok() } else { None }
}

/// Decodes bytes of one letter each: as Windows-1251 if there are words in Cyrillic letters alone,
/// such as `м` and `Забой`, otherwise as Windows-1252, whose letters beyond ASCII occur within
/// words.
pub fn single_bytes(bytes: &[u8]) -> String {
    let decode = if is_cyrillic(bytes) { cyrillic } else { western };
    bytes.iter().map(|&byte| decode(byte)).collect()
}

fn is_cyrillic(bytes: &[u8]) -> bool {
    let is_high = |byte: &u8| *byte >= 0xc0 || matches!(byte, 0xa8 | 0xb8);
    let words = bytes.split(|byte| !byte.is_ascii_alphabetic() && !is_high(byte));
    let mut has_words = false;
    for word in words.filter(|word| word.iter().any(is_high)) {
        if !word.iter().all(is_high) {
            return false;
        }
        // Single letters of Western text: × ÷ Ø ø ß Å å à.
        has_words |= !matches!(word, [0xd7 | 0xf7 | 0xd8 | 0xf8 | 0xdf | 0xc5 | 0xe5 | 0xe0]);
    }
    has_words
}

/// One byte of Windows-1251.
fn cyrillic(byte: u8) -> char {
    match byte {
        0xc0.. => {
            char::from_u32(0x410 + u32::from(byte - 0xc0)).unwrap_or(char::REPLACEMENT_CHARACTER)
        }
        0xa8 => 'Ё',
        0xb8 => 'ё',
        0xb9 => '№',
        _ => western(byte),
    }
}

/// One byte of Windows-1252. Its quotes and dashes matter; the rest of its own block is rare.
fn western(byte: u8) -> char {
    match byte {
        0x80 => '€',
        0x91 => '‘',
        0x92 => '’',
        0x93 => '“',
        0x94 => '”',
        0x96 => '–',
        0x97 => '—',
        _ => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    use super::single_bytes;

    #[test]
    fn words_tell_the_letters() {
        // `DBTM .м : Глубина`, `Tiefe in °, Länge`, `Ø 8.5 in`.
        assert_eq!(single_bytes(b"DBTM .\xec : \xc3\xeb\xf3\xe1\xe8\xed\xe0"), "DBTM .м : Глубина");
        assert_eq!(single_bytes(b"Tiefe in \xb0, L\xe4nge"), "Tiefe in °, Länge");
        assert_eq!(single_bytes(b"\xd8 8.5 in"), "Ø 8.5 in");
    }
}
