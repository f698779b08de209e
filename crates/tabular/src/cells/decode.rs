//! From bytes to text.

/// The text of a file in UTF-8 or UTF-16 with a mark, UTF-8 without, or Windows-1252 (of which
/// Latin-1 is the part that matters here). `None` if the bytes are no text.
pub(crate) fn text(bytes: &[u8]) -> Option<String> {
    let text = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => std::str::from_utf8(rest).ok()?.to_owned(),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?,
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?,
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|&byte| western(byte)).collect(),
        },
    };
    // A form feed parts the pages of a report; an old end-of-file mark may close it.
    let binary = |c: char| c.is_control() && !"\t\n\r\u{c}\u{1a}\u{85}".contains(c);
    (!text.contains(binary)).then_some(text)
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let units: Vec<u16> = pairs.iter().map(|&pair| unit(pair)).collect();
    if rest.is_empty() { String::from_utf16(&units).ok() } else { None }
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
